// SPDX-License-Identifier: Apache-2.0
// What is left out by kind of machine, and the refusal of the rest.
#include "tools/timing/machine_schedule.hpp"

#include <fmt/format.h>

#include <iterator>
#include <string_view>
#include <utility>

namespace timing {

namespace {

LeftOut all_but_bits(std::string reason) {
  LeftOut all{.requirements = {}, .reason = std::move(reason), .bounds = true};
  for (std::size_t i = 0; i < requirement_count; ++i) {
    all.requirements.insert(static_cast<Requirement>(i));
  }
  all.requirements.erase(Requirement::bits);
  return all;
}

std::string missing_text(const Schedule& schedule, std::string_view prefix) {
  std::string text;
  for (const std::string& each : missing_bounds(schedule)) {
    text += fmt::format("{}{}\n", prefix, each);
  }
  return text;
}

// Where no clock is named.
Verdict at_any_clock(const Schedule& schedule, const application::MachineDescription& machine,
                     const std::string& name) {
  if (left_out(machine).requirements.empty()) {
    const ClockRange range = clocks_that_hold(schedule.facts, schedule.load, machine.baud);
    if (range.is_empty()) {
      return {
          true,
          fmt::format("{}: not schedulable at {} baud:\n  {}\nremedy: a shorter pass{}\n", name,
                      machine.baud, to_text(range),
                      range.slower_fails == Requirement::bits ? ", or a slower serial line" : "")};
    }
    return {false, fmt::format("{}: schedulable at {} to {} Hz and {} baud\n", name,
                               range.lowest_hz, range.highest_hz, machine.baud)};
  }
  std::string refusal;
  for (const std::uint32_t clock_hz : table_clocks_hz) {
    refusal = refusal_of(schedule, machine, {clock_hz, machine.baud});
    if (refusal.empty()) {
      return {false, fmt::format("{}: nothing known is missed at {} Hz and {} baud; name clock_mhz "
                                 "to have it checked at that of the machine\n",
                                 name, clock_hz, machine.baud)};
    }
  }
  return {true, fmt::format("{}: not schedulable at {} Hz and {} baud:\n{}", name,
                            *std::rbegin(table_clocks_hz), machine.baud, refusal)};
}

}  // namespace

LeftOut left_out(const application::MachineDescription& machine) {
  if (machine.fast) {
    return all_but_bits("of code that is compiled for speed not all loops have a bound");
  }
  if (machine.shaping) return all_but_bits("input shaping hands over slots by another rule");
  if (machine.limits.s_curve) {
    return all_but_bits("to hand over ramps of third order takes more than the reserve");
  }
  // The needs of tasks, and so the turns that they have, follow from their allowances; only that
  // motion goes on while a task takes longer does not.
  LeftOut continuity{.requirements = {Requirement::allowances, Requirement::queue}, .reason = {}};
  if (machine.levels()) {
    continuity.reason = "lines above an uneven bed take longer to plan";
  } else if (!motion::kinematics::Chosen(machine.kinematics).straight()) {
    continuity.reason = "lines of such kinematics take longer to plan";
  } else {
    return {};
  }
  return continuity;
}

std::string refusal_of(const Schedule& schedule, const application::MachineDescription& machine,
                       Rate rate) {
  const auto unproved = left_out(machine).requirements;
  std::string text;
  bool clock_helps = true;
  for (const Response& response : misses(schedule, rate)) {
    if (unproved.contains(response.requirement)) continue;
    text += "  " + response.text() + "\n";
    clock_helps = clock_helps && !row_of(response.requirement).up_to_a_clock;
  }
  if (text.empty() || !schedule.load.is_whole()) return text;
  if (!clock_helps) return text + "remedy: a shorter pass; no clock helps\n";
  if (!unproved.empty()) return text + "remedy: a faster clock, or a slower serial line\n";
  const ClockRange range = clocks_that_hold(schedule.facts, schedule.load, rate.baud);
  if (range.is_empty()) return text + "remedy: a shorter pass; no clock helps\n";
  return text + fmt::format("remedy: a clock of {} to {} Hz, or a slower serial line\n",
                            range.lowest_hz, range.highest_hz);
}

Verdict verdict_on(const Schedule& schedule, const application::MachineDescription& machine,
                   std::optional<std::uint32_t> clock_hz, const std::string& name) {
  const LeftOut left = left_out(machine);
  if (!left.bounds && !missing_bounds(schedule).empty()) {
    std::string text = fmt::format("{}: not schedulable:\n{}", name, missing_text(schedule, "  "));
    for (const Problem& problem : schedule.problems) text += to_text(problem) + "\n";
    return {true, text};
  }
  std::string unproved = missing_text(schedule, "not checked: ");
  if (left.bounds) {
    unproved += fmt::format("not checked: any deadline: {}\n", left.reason);
  } else {
    for (const Requirement each : left.requirements) {
      unproved += fmt::format("not checked: {}: {}\n", row_of(each).name, left.reason);
    }
  }
  Verdict verdict;
  if (!clock_hz) {
    verdict = at_any_clock(schedule, machine, name);
  } else {
    const Rate rate{*clock_hz, machine.baud};
    const std::string refusal = refusal_of(schedule, machine, rate);
    verdict.is_refused = !refusal.empty();
    verdict.text =
        verdict.is_refused
            ? fmt::format("{}: not schedulable at {} Hz and {} baud:\n{}", name, rate.clock_hz,
                          rate.baud, refusal)
            : fmt::format("{}: {} at {} Hz and {} baud\n", name,
                          left.requirements.empty() ? "schedulable" : "nothing known is missed",
                          rate.clock_hz, rate.baud);
  }
  return {verdict.is_refused, unproved + verdict.text};
}

}  // namespace timing
