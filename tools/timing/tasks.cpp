// SPDX-License-Identifier: Apache-2.0
// The list of tasks, as Application::update() calls them.
#include "tools/timing/tasks.hpp"

#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

namespace timing {

namespace {

// In the order of units::Task.
constexpr const char* names[] = {
    "motion: stops, homing",  "serial line: lines in, their answers",
    "commands: one of them",  "refill: segments to the step generator",
    "heat: sensors, heaters", "faults",
    "reports at intervals",
};
constexpr std::uint32_t pass = 1'000;

struct Places {
  std::set<Address> begins, ends;
};

Places places_of(const Program& program, std::uint32_t task) {
  Places places;
  for (const TaskMarker& marker : program.task_markers) {
    if (marker.task != task) continue;
    (marker.is_end != 0 ? places.ends : places.begins).insert(marker.address);
  }
  if (places.begins.empty() || places.ends.empty()) {
    throw std::runtime_error(fmt::format("the image does not mark the task {}", names[task]));
  }
  return places;
}

Address main_of(const Program& program) {
  const auto found = program.addresses.find("main");
  if (found == program.addresses.end()) throw std::runtime_error("the image has no main");
  return found->second;
}

std::string ratio_of(const TaskRow& row) {
  if (!row.bound || row.measured.longest == 0) return "-";
  return fmt::format("{:.1f}",
                     static_cast<double>(*row.bound) / static_cast<double>(row.measured.longest));
}

}  // namespace

void watch_tasks(const Program& program, Analysis& analysis, Calls& calls) {
  const Address start = analysis.round_start(main_of(program));
  calls.watch(pass, {start}, {start});
  for (std::uint32_t task = 0; task < std::size(names); ++task) {
    const Places places = places_of(program, task);
    calls.watch(task, places.begins, places.ends);
  }
}

std::vector<TaskRow> task_rows(const Program& program, Analysis& analysis, const Calls& calls) {
  std::vector<TaskRow> rows{{.name = "the pass over all tasks",
                             .bound = analysis.round(main_of(program)),
                             .measured = calls.span(pass)}};
  for (std::uint32_t task = 0; task < std::size(names); ++task) {
    const Places places = places_of(program, task);
    const Address function = program.function_at(*places.begins.begin());
    rows.push_back({.name = names[task],
                    .bound = analysis.span(function, places.begins, places.ends),
                    .measured = calls.span(task)});
  }
  return rows;
}

std::string to_text(const std::vector<TaskRow>& rows, std::uint32_t clock_hz) {
  std::string text = fmt::format("{:<40} {:>14} {:>14} {:>10} {:>8} {:>8}\n", "task",
                                 "bound, clocks", "longest, clocks", "ms", "ratio", "times");
  for (const TaskRow& row : rows) {
    const std::string bound = row.bound ? fmt::format("{}", *row.bound) : "none";
    const double ms = 1000.0 * static_cast<double>(row.measured.longest) / clock_hz;
    text += fmt::format("{:<40} {:>14} {:>14} {:>10.3f} {:>8} {:>8}\n", row.name, bound,
                        row.measured.longest, ms, ratio_of(row), row.measured.calls);
  }
  return text;
}

std::string to_json(const std::vector<TaskRow>& rows) {
  auto list = nlohmann::json::array();
  for (const TaskRow& row : rows) {
    nlohmann::json task{{"name", row.name},
                        {"measured_clocks", row.measured.longest},
                        {"times", row.measured.calls}};
    if (row.bound) task["bound_clocks"] = *row.bound;
    list.push_back(task);
  }
  return nlohmann::json{{"tasks", list}}.dump(2) + "\n";
}

}  // namespace timing
