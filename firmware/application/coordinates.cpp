// SPDX-License-Identifier: Apache-2.0
// Exact integer conversions of lengths, positions and feedrates.
#include "application/coordinates.hpp"

#include <algorithm>

#include "motion/limits.hpp"

namespace application {
namespace {

// Rounded to nearest, halves away from 0.
constexpr std::int64_t divided(std::int64_t value, std::int64_t divisor) {
  return (value < 0 ? value - divisor / 2 : value + divisor / 2) / divisor;
}

// A number of the G-code counts millionths; a millionth of an inch is 25.4 nm. |value| < 2^32 *
// 10^6, so the product stays below 2^61.
constexpr std::int64_t nanometers_of_inches(std::int64_t millionths) {
  return divided(millionths * 254, 10);
}

}  // namespace

std::optional<units::Nanometers> Coordinates::length(const gcode::Command& command,
                                                     char letter) const {
  const auto value = command.value(letter);
  if (!value) return std::nullopt;
  return units::Nanometers(inches_ ? nanometers_of_inches(*value) : *value);
}

Positions Coordinates::target_of(const gcode::Command& command) const {
  Positions target = logical_;
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    const auto value = length(command, units::axis_letters[i]);
    if (!value) continue;
    const bool extruder = i == units::index_of(units::Axis::e);
    const bool relative = extruder ? extruder_relative_ : axes_relative_;
    target[i] = relative ? logical_[i] + *value : *value;
  }
  return target;
}

Positions Coordinates::machine_target(const Positions& target, const Positions& machine) const {
  Positions result;
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    units::Nanometers distance = target[i] - logical_[i];
    if (i == units::index_of(units::Axis::e) && flow_percent_ != 100) {
      distance = units::Nanometers(divided(distance.count() * flow_percent_, 100));
    }
    result[i] = machine[i] + distance;
  }
  return result;
}

void Coordinates::take_feedrate(const gcode::Command& command) {
  const auto per_minute = length(command, 'F');
  if (!per_minute || per_minute->count() <= 0) return;
  constexpr std::int64_t nanometers_per_minute = 60'000;  // in one um/s
  const std::int64_t speed = divided(per_minute->count(), nanometers_per_minute);
  feedrate_ = units::MicrometersPerSecond(
      static_cast<std::int32_t>(std::clamp<std::int64_t>(speed, 1, motion::max_speed.count())));
}

units::MicrometersPerSecond Coordinates::feedrate() const {
  if (planned_percent_ == 100) return feedrate_;
  const std::int64_t speed = divided(std::int64_t{feedrate_.count()} * planned_percent_, 100);
  return units::MicrometersPerSecond(
      static_cast<std::int32_t>(std::clamp<std::int64_t>(speed, 1, motion::max_speed.count())));
}

}  // namespace application
