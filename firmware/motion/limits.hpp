// SPDX-License-Identifier: Apache-2.0
// The limits of the machine's axes and how filament is retracted: set by the machine description,
// changed by M92 and M201 to M209.
#pragma once

#include <cstdint>
#include <expected>
#include <optional>

#include "motion/fault.hpp"
#include "units/axes.hpp"
#include "units/position.hpp"
#include "units/quantity.hpp"

namespace motion {

// How an axis finds its end stop.
struct HomingParameters {
  units::MicrometersPerSecond fast_speed{};
  units::MicrometersPerSecond slow_speed{};
  units::Nanometers back_off{};  // distance between the fast and the slow approach
  std::uint8_t end_stop{};  // input of the end stop, 0 .. 7
  bool towards_positive{};  // side of the axis on which the end stop lies
  units::Nanometers position{};  // where the axis is when its end stop has just switched
};

struct AxisLimits {
  units::StepsPerMeter steps_per_meter{};  // 80 steps/mm = 80 000; 62.745 steps/mm = 62 745
  units::Nanometers travel{};  // positions 0 .. travel are allowed; 0: no bounds
  units::MicrometersPerSecond max_speed{};
  units::MicrometersPerSecondSquared max_acceleration{};
  units::MicrometersPerSecond jerk{};  // largest change of speed without a ramp
  std::optional<HomingParameters> homing{};
};

// How G10 draws filament back and G11 pushes it forward again. The defaults are Marlin's.
struct Retraction {
  units::Nanometers length{3'000'000};
  units::MicrometersPerSecond speed{45'000};
  units::Nanometers lift{};  // of Z, until G11
  units::Nanometers extra{};  // beyond what was drawn back; below 0: less than that
  units::MicrometersPerSecond recovery_speed{8'000};
  bool automatic{};  // also for moves of E alone
};

struct Limits {
  units::PerAxis<AxisLimits> axes{};
  units::MicrometersPerSecondSquared print_acceleration{};
  units::MicrometersPerSecondSquared travel_acceleration{};
  units::MicrometersPerSecondSquared retract_acceleration{};
  units::MicrometersPerSecond min_print_speed{};
  units::MicrometersPerSecond min_travel_speed{};
  units::Nanometers junction_deviation{};  // 0: X, Y and Z are limited by their jerk
  std::uint8_t min_cruise_percent{};  // of a line on which the nominal speed is not reached
  bool s_curve{};  // ramps are of third order, where the image has them
  Retraction retraction{};

  constexpr AxisLimits& of(units::Axis axis) { return axes[units::index_of(axis)]; }
  constexpr const AxisLimits& of(units::Axis axis) const { return axes[units::index_of(axis)]; }
};

// Bounds of what the integer arithmetic of this folder covers, far beyond any printer.
inline constexpr units::StepsPerMeter max_steps_per_meter{10'000'000};
inline constexpr units::MicrometersPerSecond max_speed{10'000'000};
inline constexpr units::MicrometersPerSecondSquared max_acceleration{100'000'000};
inline constexpr units::Nanometers max_junction_deviation{1'000'000};
inline constexpr units::Nanometers max_retraction{100'000'000};  // and lift

// Feedrates of G-code are per minute: so many nm/min are one um/s.
inline constexpr std::int64_t nanometers_per_minute = 60'000;

// A value out of range changes nothing and is returned as the fault to report.
using Accepted = std::expected<void, Fault>;

// M92, more than 0. Only with an empty planner, and its position is to be set again afterwards.
Accepted set_steps_per_meter(Limits& limits, units::Axis axis, units::StepsPerMeter value);
// M203, more than 0.
Accepted set_max_speed(Limits& limits, units::Axis axis, units::MicrometersPerSecond value);
// M201, more than 0.
Accepted set_max_acceleration(Limits& limits, units::Axis axis,
                              units::MicrometersPerSecondSquared value);
// M205 X Y Z E, 0 or more; 0: every change of speed is a ramp.
Accepted set_jerk(Limits& limits, units::Axis axis, units::MicrometersPerSecond value);
// M204 P, T, R, more than 0.
Accepted set_print_acceleration(Limits& limits, units::MicrometersPerSecondSquared value);
Accepted set_travel_acceleration(Limits& limits, units::MicrometersPerSecondSquared value);
Accepted set_retract_acceleration(Limits& limits, units::MicrometersPerSecondSquared value);
// M205 S, T, 0 or more.
Accepted set_min_print_speed(Limits& limits, units::MicrometersPerSecond value);
Accepted set_min_travel_speed(Limits& limits, units::MicrometersPerSecond value);
// M205 J, 0 or more; 0: classic jerk.
Accepted set_junction_deviation(Limits& limits, units::Nanometers value);
// M207 S and Z, 0 or more, and F in nm/min, more than 0.
Accepted set_retraction_length(Limits& limits, units::Nanometers value);
Accepted set_retraction_lift(Limits& limits, units::Nanometers value);
Accepted set_retraction_speed(Limits& limits, units::Nanometers per_minute);
// M208 S, of either sign, and F.
Accepted set_recovery_extra(Limits& limits, units::Nanometers value);
Accepted set_recovery_speed(Limits& limits, units::Nanometers per_minute);
// M209 S, 0 or another number.
Accepted set_automatic_retraction(Limits& limits, units::Nanometers value);

// The first axis on which `target`, also lower by `lift`, leaves the travel; axes not in `homed`
// have no bounds yet.
std::optional<units::Axis> check_bounds(const Limits& limits, units::AxisSet homed,
                                        const units::PerAxis<units::Position>& target,
                                        units::Nanometers lift = {});

}  // namespace motion
