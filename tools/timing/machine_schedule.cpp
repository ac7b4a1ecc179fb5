// SPDX-License-Identifier: Apache-2.0
// What is left out by kind of machine, and the refusal of the rest.
#include "tools/timing/machine_schedule.hpp"

#include <fmt/format.h>

namespace timing {

LeftOut left_out(const application::MachineDescription& machine) {
  if (machine.shaping || machine.limits.s_curve) {
    LeftOut all{.requirements = {},
                .reason = machine.shaping
                              ? "input shaping hands over slots by another rule"
                              : "to hand over ramps of third order takes more than the reserve"};
    for (std::size_t i = 0; i < requirement_count; ++i) {
      all.requirements.insert(static_cast<Requirement>(i));
    }
    all.requirements.erase(Requirement::bits);
    return all;
  }
  // The needs of tasks, and so the turns that they have, follow from their allowances; only that
  // motion goes on while a task takes longer does not.
  const std::set<Requirement> continuity{Requirement::allowances, Requirement::queue};
  if (machine.levels()) {
    return {.requirements = continuity, .reason = "lines above an uneven bed take longer to plan"};
  }
  if (!motion::kinematics::Chosen(machine.kinematics).straight()) {
    return {.requirements = continuity, .reason = "lines of such kinematics take longer to plan"};
  }
  return {};
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

}  // namespace timing
