// SPDX-License-Identifier: Apache-2.0
// The tasks of the table (firmware/application/task_table.hpp) in an image.
#include "tools/timing/tasks.hpp"

#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "motion/profile.hpp"
#include "units/event_bound.hpp"

namespace timing {

namespace {

using units::Task;

constexpr std::uint32_t pass = 1'000;
constexpr std::uint32_t task_count = units::task_count;

const application::TaskRow& row_of(std::uint32_t task) { return application::task_table[task]; }

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
    throw std::runtime_error(fmt::format("the image does not mark the task {}", row_of(task).name));
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

nlohmann::json list_of(const std::vector<TaskRow>& rows) {
  auto list = nlohmann::json::array();
  for (const TaskRow& row : rows) {
    nlohmann::json task{{"name", row.name},
                        {"measured_clocks", row.measured.longest},
                        {"times", row.measured.calls},
                        {"budget_clocks", row.budget}};
    if (row.bound) task["bound_clocks"] = *row.bound;
    list.push_back(task);
  }
  return list;
}

}  // namespace

void watch_tasks(const Program& program, Analysis& analysis, Calls& calls) {
  const Address start = analysis.round_start(main_of(program));
  calls.watch(pass, {start}, {start});
  for (std::uint32_t task = 0; task < task_count; ++task) {
    const Places places = places_of(program, task);
    calls.watch(task, places.begins, places.ends);
  }
}

std::vector<TaskRow> task_rows(const Program& program, Analysis& analysis) {
  Clocks all = 0;
  for (const application::TaskRow& row : application::task_table) all += row.budget;
  std::vector<TaskRow> rows{{.name = "the pass over all tasks",
                             .bound = analysis.round(main_of(program)),
                             .budget = all,
                             .measured = {}}};
  for (std::uint32_t task = 0; task < task_count; ++task) {
    const Places places = places_of(program, task);
    const Address function = program.function_at(*places.begins.begin());
    rows.push_back({.name = std::string(row_of(task).name),
                    .bound = analysis.span(function, places.begins, places.ends),
                    .budget = row_of(task).budget,
                    .measured = {}});
  }
  return rows;
}

void add_measured(std::vector<TaskRow>& rows, const Calls& calls) {
  rows.at(0).measured = calls.span(pass);
  for (std::uint32_t task = 0; task < task_count; ++task) {
    rows.at(1 + task).measured = calls.span(task);
  }
}

Load load_of(const Program& program, Analysis& analysis, const std::vector<TaskRow>& rows) {
  const Address main = main_of(program);
  const Address start = analysis.round_start(main);
  Load load{.pass = rows.at(0).bound,
            .tasks = {},
            .start = {},
            .gaps = {},
            .line = {},
            .refill_without_line = {}};
  const auto handing_over = program.find("MotionTask::hand_over_line");  // where it is not inlined
  if (handing_over.size() == 1) {
    load.line = analysis.bound(handing_over[0]);
  } else {
    analysis.add({.place = program.place_of(main),
                  .function = "MotionTask::hand_over_line",
                  .what = "the image has no such function",
                  .remedy = "keep the compiler from inlining it"});
  }
  std::set<Address> begins{start};
  for (std::uint32_t task = 0; task < task_count; ++task) {
    load.tasks[task] = rows.at(1 + task).bound;
    const Places places = places_of(program, task);
    // Where the compiler has not inlined the loop's body there is no way within one function.
    if (const Address begin = *places.begins.begin(); program.function_at(begin) != main) {
      analysis.add({.place = program.place_of(begin),
                    .function = program.name_of(begin),
                    .what = "a task begins in a function that main's loop calls",
                    .remedy = "have the compiler inline it"});
      return load;
    }
    begins.insert(places.begins.begin(), places.begins.end());
  }
  load.start = analysis.span(main, {start}, begins);
  for (std::uint32_t task = 0; task < task_count; ++task) {
    load.gaps[task] = analysis.span(main, places_of(program, task).ends, begins);
  }
  return load;
}

std::optional<Clocks> refill_without_line(const Program& program, const Costs& costs, bool has_zbb,
                                          std::set<Problem>& problems) {
  Program without = program;
  for (EventMarker& marker : without.event_markers) {
    if (marker.event == static_cast<std::uint32_t>(units::Event::line_begun)) marker.most = 0;
    // What is left of a line before.
    if (marker.event == static_cast<std::uint32_t>(units::Event::segment_made)) {
      marker.most = motion::most_phases;
    }
  }
  const Places places = places_of(without, static_cast<std::uint32_t>(Task::refill));
  const Address function = without.function_at(*places.begins.begin());
  Analysis analysis(without, costs, has_zbb);
  const auto bound = analysis.span(function, places.begins, places.ends);
  problems.insert(analysis.problems().begin(), analysis.problems().end());
  return bound;
}

std::string to_text(const std::vector<TaskRow>& rows, std::uint32_t clock_hz) {
  std::string text =
      fmt::format("{:<40} {:>14} {:>14} {:>10} {:>8} {:>8} {:>8}\n", "task", "bound, clocks",
                  "longest, clocks", "ms", "ratio", "times", "budget");
  for (const TaskRow& row : rows) {
    const std::string bound = row.bound ? fmt::format("{}", *row.bound) : "none";
    const double ms = 1000.0 * static_cast<double>(row.measured.longest) / clock_hz;
    text += fmt::format("{:<40} {:>14} {:>14} {:>10.3f} {:>8} {:>8} {:>8}\n", row.name, bound,
                        row.measured.longest, ms, ratio_of(row), row.measured.calls, row.budget);
  }
  return text;
}

std::string to_json(const std::vector<TaskRow>& rows) {
  return nlohmann::json{{"tasks", list_of(rows)}}.dump(2) + "\n";
}

std::string to_json(const std::vector<TaskRow>& rows, const CostSum& sum) {
  const nlohmann::json costs{{"instructions", sum.instructions()},
                             {"costs_clocks", sum.costs()},
                             {"mcycle_clocks", sum.clocks()},
                             {"instructions_that_differ", sum.differences()}};
  return nlohmann::json{{"tasks", list_of(rows)}, {"costs", costs}}.dump(2) + "\n";
}

}  // namespace timing
