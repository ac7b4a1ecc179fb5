// SPDX-License-Identifier: Apache-2.0
// The checks of arguments, and the messages of their refusals.
#include "application/argument_limit.hpp"

#include <algorithm>

#include "units/loop_bound.hpp"

namespace application {
namespace {

bool is_within(const gcode::Command& command, const ArgumentLimit& limit) {
  const auto value = command.integer(limit.letter);
  return value && *value >= limit.least && *value <= limit.most;
}

bool is_kept(const gcode::Command& command, const ArgumentLimit& limit) {
  if (!command.has(limit.letter)) return !limit.required;
  switch (limit.check) {
    case Check::none:
    case Check::clamped:
      return true;
    case Check::number:
      return command.has_number(limit.letter);
    case Check::refused:
      return is_within(command, limit);
    case Check::tool:
      return !command.has_number(limit.letter) || is_within(command, limit);
  }
  return true;
}

}  // namespace

const ArgumentLimit* violated(const gcode::Command& command, ArgumentLimits limits) {
  units::LoopBound<most_limits> bound;
  for (const ArgumentLimit& limit : limits) {
    bound.next();
    if (!is_kept(command, limit)) return &limit;
  }
  return nullptr;
}

host_link::TextLine describe(const gcode::Command& command, const ArgumentLimit& limit) {
  host_link::TextLine line;
  line.text("echo:");
  if (!command.has(limit.letter)) {
    line.text("Parameter ").character(limit.letter).text(" missing");
    return line;
  }
  switch (limit.check) {
    case Check::none:
    case Check::clamped:
    case Check::number:
      line.text("Number missing after ").character(limit.letter);
      break;
    case Check::refused:
      line.character(limit.letter).text(" not within ").integer(limit.least);
      line.text(" to ").integer(limit.most);
      break;
    case Check::tool:
      line.character(command.letter).integer(command.code);
      line.text(" Invalid extruder ");
      line.integer(command.integer(limit.letter).value_or(0));
      break;
  }
  return line;
}

std::int64_t clamped(ArgumentLimits limits, char letter, std::int64_t value,
                     std::int64_t units_per_one) {
  units::LoopBound<most_limits> bound;
  for (const ArgumentLimit& limit : limits) {
    bound.next();
    if (limit.letter != letter || limit.check != Check::clamped) continue;
    return std::clamp(value, limit.least * units_per_one, limit.most * units_per_one);
  }
  return value;
}

}  // namespace application
