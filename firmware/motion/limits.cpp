// SPDX-License-Identifier: Apache-2.0
// Changes of the machine's limits at run time, each refused if out of range.
#include "motion/limits.hpp"

#include <algorithm>

namespace motion {

namespace {

template <class Value>
Accepted set(Value& place, Value value, Value least, Value most, Fault fault) {
  if (value < least || value > most) return std::unexpected(fault);
  place = value;
  return {};
}

Accepted set_acceleration(units::MicrometersPerSecondSquared& place,
                          units::MicrometersPerSecondSquared value) {
  return set(place, value, units::MicrometersPerSecondSquared(1), max_acceleration,
             Fault::acceleration_out_of_range);
}

Accepted set_speed(units::MicrometersPerSecond& place, units::MicrometersPerSecond value,
                   std::int32_t least, Fault fault) {
  return set(place, value, units::MicrometersPerSecond(least), max_speed, fault);
}

Accepted set_retraction(units::Nanometers& place, units::Nanometers value,
                        units::Nanometers least) {
  return set(place, value, least, max_retraction, Fault::length_out_of_range);
}

Accepted set_speed_per_minute(units::MicrometersPerSecond& place, units::Nanometers per_minute) {
  const std::int64_t speed = per_minute.count() / nanometers_per_minute;
  if (speed > max_speed.count()) return std::unexpected(Fault::speed_out_of_range);
  const auto narrow = static_cast<std::int32_t>(std::max<std::int64_t>(speed, 0));
  return set_speed(place, units::MicrometersPerSecond(narrow), 1, Fault::speed_out_of_range);
}

}  // namespace

Accepted set_steps_per_meter(Limits& limits, units::Axis axis, units::StepsPerMeter value) {
  return set(limits.of(axis).steps_per_meter, value, units::StepsPerMeter(1), max_steps_per_meter,
             Fault::steps_per_meter_out_of_range);
}

Accepted set_max_speed(Limits& limits, units::Axis axis, units::MicrometersPerSecond value) {
  return set_speed(limits.of(axis).max_speed, value, 1, Fault::speed_out_of_range);
}

Accepted set_max_acceleration(Limits& limits, units::Axis axis,
                              units::MicrometersPerSecondSquared value) {
  return set_acceleration(limits.of(axis).max_acceleration, value);
}

Accepted set_jerk(Limits& limits, units::Axis axis, units::MicrometersPerSecond value) {
  return set_speed(limits.of(axis).jerk, value, 0, Fault::jerk_out_of_range);
}

Accepted set_print_acceleration(Limits& limits, units::MicrometersPerSecondSquared value) {
  return set_acceleration(limits.print_acceleration, value);
}

Accepted set_travel_acceleration(Limits& limits, units::MicrometersPerSecondSquared value) {
  return set_acceleration(limits.travel_acceleration, value);
}

Accepted set_retract_acceleration(Limits& limits, units::MicrometersPerSecondSquared value) {
  return set_acceleration(limits.retract_acceleration, value);
}

Accepted set_min_print_speed(Limits& limits, units::MicrometersPerSecond value) {
  return set_speed(limits.min_print_speed, value, 0, Fault::speed_out_of_range);
}

Accepted set_min_travel_speed(Limits& limits, units::MicrometersPerSecond value) {
  return set_speed(limits.min_travel_speed, value, 0, Fault::speed_out_of_range);
}

Accepted set_junction_deviation(Limits& limits, units::Nanometers value) {
  return set(limits.junction_deviation, value, units::Nanometers(), max_junction_deviation,
             Fault::junction_deviation_out_of_range);
}

Accepted set_retraction_length(Limits& limits, units::Nanometers value) {
  return set_retraction(limits.retraction.length, value, units::Nanometers());
}

Accepted set_retraction_lift(Limits& limits, units::Nanometers value) {
  return set_retraction(limits.retraction.lift, value, units::Nanometers());
}

Accepted set_retraction_speed(Limits& limits, units::Nanometers per_minute) {
  return set_speed_per_minute(limits.retraction.speed, per_minute);
}

Accepted set_recovery_extra(Limits& limits, units::Nanometers value) {
  return set_retraction(limits.retraction.extra, value, -max_retraction);
}

Accepted set_recovery_speed(Limits& limits, units::Nanometers per_minute) {
  return set_speed_per_minute(limits.retraction.recovery_speed, per_minute);
}

Accepted set_automatic_retraction(Limits& limits, units::Nanometers value) {
  limits.retraction.automatic = value != units::Nanometers();
  return {};
}

std::optional<units::Axis> check_bounds(const Limits& limits, units::AxisSet homed,
                                        const units::PerAxis<units::Position>& target,
                                        units::Nanometers lift) {
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    const auto axis = static_cast<units::Axis>(i);
    const units::Nanometers travel = limits.axes[i].travel;
    const bool bounded = homed.contains(axis) && travel > units::Nanometers(0);
    const units::Nanometers lowest = axis == units::Axis::z ? lift : units::Nanometers(0);
    if (bounded && (target[i].whole() < lowest || target[i] > travel)) return axis;
  }
  return std::nullopt;
}

}  // namespace motion
