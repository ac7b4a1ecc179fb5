// SPDX-License-Identifier: Apache-2.0
// Whether an image meets the deadlines of the machine that it is for, as far as that is proved.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>

#include "application/machine_description.hpp"
#include "tools/timing/schedule_report.hpp"

namespace timing {

struct LeftOut {
  std::set<Requirement> requirements;
  std::string reason;  // empty where nothing is left out
  bool bounds{};  // nor that everything has a bound
};
// What is not proved of machines with such parts.
LeftOut left_out(const application::MachineDescription& machine);

// Why the image is refused at this rate, a line for each reason, and what would help; nothing where
// it is not refused.
std::string refusal_of(const Schedule& schedule, const application::MachineDescription& machine,
                       Rate rate);

struct Verdict {
  bool is_refused{};
  std::string text;  // lines: what is not proved, and the result or the reasons with a remedy
};
// On the image for the machine of that name. Without a clock, what no clock helps is refused.
Verdict verdict_on(const Schedule& schedule, const application::MachineDescription& machine,
                   std::optional<std::uint32_t> clock_hz, const std::string& name);

}  // namespace timing
