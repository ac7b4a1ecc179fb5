// SPDX-License-Identifier: Apache-2.0
// The list of tasks, as Application::update() calls them.
#include "tools/timing/tasks.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

namespace timing {

namespace {

struct Task {
  const char* function;
  const char* does;
};

constexpr Task tasks[] = {
    {"application::MotionTask::update", "stops, homing"},
    {"application::Application::exchange_bytes", "lines in, with their answers"},
    {"application::Application::act_on_emergencies", "commands that act at once"},
    {"application::CommandExecutor::update", "one command"},
    {"application::Application::refill", "segments to the step generator"},
    {"application::HeatTask::update", "heaters"},
    {"application::Application::look_for_faults", "faults"},
    {"application::Application::report", "reports at intervals"},
    {"application::Application::transmit", "bytes out"},
};

Address only(const Program& program, const char* name) {
  const auto found = program.find(name);
  if (found.size() != 1) {
    throw std::runtime_error(
        fmt::format("{}: the image has {} such functions", name, found.size()));
  }
  return found[0];
}

std::string ratio_of(const TaskRow& row) {
  if (!row.bound || row.measured.longest == 0) return "-";
  return fmt::format("{:.1f}",
                     static_cast<double>(*row.bound) / static_cast<double>(row.measured.longest));
}

}  // namespace

std::vector<TaskRow> task_rows(const Program& program, Analysis& analysis, const Calls& calls) {
  std::vector<TaskRow> rows{{.name = "main, each round",
                             .does = "the pass over all tasks",
                             .bound = analysis.round(only(program, "main")),
                             .measured = calls.rounds()}};
  for (const Task& task : tasks) {
    const Address function = only(program, task.function);
    const auto measured = calls.measured().find(function);
    rows.push_back(
        {.name = task.function,
         .does = task.does,
         .bound = analysis.bound(function),
         .measured = measured != calls.measured().end() ? measured->second : Calls::Measured{}});
  }
  return rows;
}

std::string to_text(const std::vector<TaskRow>& rows, std::uint32_t clock_hz) {
  std::string text = fmt::format("{:<46} {:>12} {:>10} {:>9} {:>9} {:>10}  {}\n", "task", "bound",
                                 "measured", "ratio", "calls", "ms", "does");
  for (const TaskRow& row : rows) {
    const std::string bound = row.bound ? fmt::format("{}", *row.bound) : "none";
    const double ms = 1000.0 * static_cast<double>(row.measured.longest) / clock_hz;
    text += fmt::format("{:<46} {:>12} {:>10} {:>9} {:>9} {:>10.3f}  {}\n", row.name, bound,
                        row.measured.longest, ratio_of(row), row.measured.calls, ms, row.does);
  }
  return text;
}

std::string to_json(const std::vector<TaskRow>& rows) {
  auto list = nlohmann::json::array();
  for (const TaskRow& row : rows) {
    nlohmann::json task{{"name", row.name},
                        {"does", row.does},
                        {"measured_clocks", row.measured.longest},
                        {"calls", row.measured.calls}};
    if (row.bound) task["bound_clocks"] = *row.bound;
    list.push_back(task);
  }
  return nlohmann::json{{"tasks", list}}.dump(2) + "\n";
}

}  // namespace timing
