// SPDX-License-Identifier: Apache-2.0
// Percentages of what is allowed, one table for each baud rate.
#include "tools/timing/schedule_report.hpp"
#include "tools/timing/rounds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace timing {

namespace {

constexpr std::uint32_t rates[] = {OFFERED_BAUD_RATES};

std::string cell(const Response& response) {
  if (!response.is_bounded) return "no bound";
  auto part = static_cast<double>(*response.worst);
  auto whole = static_cast<double>(response.allowed);
  if (response.is_least) std::swap(part, whole);
  const std::string percent = whole == 0 ? "-" : fmt::format("{:.0f} %", 100 * part / whole);
  return response.holds ? percent : "no: " + percent;
}

std::string table(const Schedule& schedule, std::uint32_t baud) {
  std::string text = fmt::format("{:<46}", fmt::format("{} baud, of what is allowed", baud));
  for (const std::uint32_t hz : table_clocks_hz) {
    text += fmt::format("{:>13}", fmt::format("{} MHz", hz / 1'000'000));
  }
  text += '\n';
  for (std::size_t i = 0; i < requirement_count; ++i) {
    const auto requirement = static_cast<Requirement>(i);
    text += fmt::format("{:<46}", row_of(requirement).name);
    for (const std::uint32_t hz : table_clocks_hz) {
      const auto response = respond(requirement, schedule.facts, schedule.load, {hz, baud});
      text += fmt::format("{:>13}", cell(response));
    }
    text += '\n';
  }
  return text;
}

nlohmann::json to_json(const Response& response, Rate rate) {
  nlohmann::json entry{{"requirement", row_of(response.requirement).name},
                       {"clock_hz", rate.clock_hz},
                       {"baud", rate.baud},
                       {"holds", response.holds},
                       {"bounded", response.is_bounded}};
  if (!response.is_bounded) return entry;
  entry["worst"] = *response.worst;
  entry["allowed"] = response.allowed;
  entry["unit"] = row_of(response.requirement).unit;
  return entry;
}

}  // namespace

std::string to_text(const ClockRange& range) {
  const auto name = [](const std::optional<Requirement>& which) { return row_of(*which).name; };
  if (range.lowest_hz > fastest_clock_hz) {
    return fmt::format("no clock: {} at none", name(range.slower_fails));
  }
  if (range.highest_hz < slowest_clock_hz) {
    return fmt::format("no clock: {} at none", name(range.faster_fails));
  }
  if (range.is_empty()) {
    return fmt::format("no clock: {} needs {} Hz at least, {} {} Hz at most",
                       name(range.slower_fails), range.lowest_hz, name(range.faster_fails),
                       range.highest_hz);
  }
  std::string text = fmt::format("lowest clock {} Hz", range.lowest_hz);
  if (range.slower_fails) text += fmt::format(" ({})", name(range.slower_fails));
  if (range.faster_fails) {
    text += fmt::format(", highest {} Hz ({})", range.highest_hz, name(range.faster_fails));
  }
  return text;
}

std::vector<std::uint32_t> offered_baud_rates() { return {std::begin(rates), std::end(rates)}; }

Schedule schedule_of(const Program& program, const Costs& costs, bool has_zbb, const Facts& facts) {
  refuse_interrupts(program, has_zbb);
  Analysis analysis(program, costs, has_zbb);
  Schedule schedule{
      .facts = facts, .load = {}, .rows = task_rows(program, analysis), .problems = {}};
  try {
    schedule.load = load_of(program, analysis, schedule.rows);
  } catch (const Unbounded& error) {
    analysis.add(error.problem());
  }
  schedule.problems = analysis.problems();
  schedule.load.refill_without_line =
      refill_without_line(program, costs, has_zbb, schedule.problems);
  return schedule;
}

std::vector<std::string> missing_bounds(const Schedule& schedule) {
  std::vector<std::string> missing;
  const auto note = [&](const std::optional<Clocks>& bound, std::string_view name) {
    if (!bound) missing.push_back(fmt::format("\"{}\" has no bound", name));
  };
  for (const TaskRow& row : schedule.rows) note(row.bound, row.name);
  if (!schedule.load.gaps_are_bounded()) note(std::nullopt, "a gap between tasks");
  note(schedule.load.line, "a line handed over");
  note(schedule.load.refill_without_line, "a refill without a line");
  return missing;
}

Load bounded_part(const std::vector<TaskRow>& rows) {
  Load load;
  Clocks sum = 0;
  for (std::size_t task = 0; task < units::task_count; ++task) {
    load.tasks[task] = rows.at(1 + task).bound.value_or(0);
    sum += *load.tasks[task];
  }
  load.pass = sum;
  load.gaps.fill(0);
  load.start = load.line = load.refill_without_line = 0;
  return load;
}

std::vector<Response> misses(const Schedule& schedule, Rate rate) {
  const bool is_whole = schedule.load.is_whole();
  const Load load = is_whole ? schedule.load : bounded_part(schedule.rows);
  std::vector<Response> missed;
  for (const Response& response : respond(schedule.facts, load, rate)) {
    if (!response.holds) missed.push_back(response);
  }
  return missed;
}

bool is_schedulable(const Schedule& schedule) {
  return schedule.load.is_whole() && std::ranges::none_of(rates, [&](std::uint32_t baud) {
           return clocks_that_hold(schedule.facts, schedule.load, baud).is_empty();
         });
}

std::string to_text(const Schedule& schedule) {
  std::string text;
  for (const std::string& reason : missing_bounds(schedule)) {
    text += "not schedulable: " + reason + "\n";
  }
  if (!schedule.load.is_whole()) {
    text += "what follows is that of the tasks with a bound alone: a yes is no proof\n";
  }
  if (schedule.load.is_whole()) {
    text += fmt::format(
        "clocks at most: a line {}, a refill without one {}, from one task to the next {}\n",
        *schedule.load.line, *schedule.load.refill_without_line, longest_gap(schedule.load));
  }
  Schedule shown = schedule;
  if (!schedule.load.is_whole()) shown.load = bounded_part(schedule.rows);
  for (const std::uint32_t baud : rates) {
    text += "\n" + table(shown, baud);
    text += to_text(clocks_that_hold(shown.facts, shown.load, baud)) + "\n";
  }
  return text;
}

std::string to_json(const Schedule& schedule) {
  auto responses = nlohmann::json::array(), clocks = nlohmann::json::array();
  for (const std::uint32_t baud : rates) {
    for (const std::uint32_t hz : table_clocks_hz) {
      for (const Response& each : respond(schedule.facts, schedule.load, {hz, baud})) {
        responses.push_back(to_json(each, {hz, baud}));
      }
    }
    if (!schedule.load.is_whole()) continue;
    const ClockRange range = clocks_that_hold(schedule.facts, schedule.load, baud);
    clocks.push_back({{"baud", baud},
                      {"schedulable", !range.is_empty()},
                      {"lowest_hz", range.lowest_hz},
                      {"highest_hz", range.highest_hz},
                      {"reason", to_text(range)}});
  }
  nlohmann::json all = nlohmann::json::parse(to_json(schedule.rows));
  if (schedule.load.is_whole()) {
    all["gap_clocks"] = longest_gap(schedule.load);
    all["line_clocks"] = *schedule.load.line;
    all["refill_without_line_clocks"] = *schedule.load.refill_without_line;
  }
  all["missing_bounds"] = missing_bounds(schedule);
  all["responses"] = responses;
  all["clocks"] = clocks;
  return all.dump(2) + "\n";
}

}  // namespace timing
