// SPDX-License-Identifier: Apache-2.0
// The override of the step generator, and what the planner must know of it.
#include "application/pace.hpp"

#include <algorithm>

namespace application {
namespace {

constexpr int time_fraction_bits = 17;
constexpr int slope_fraction_bits = 32;

// In 2^-32 per clock.
std::uint32_t slope_of(const motion::Limits& limits, units::Hertz clock) {
  const std::int32_t planned =
      std::max({limits.print_acceleration.count(), limits.travel_acceleration.count(),
                limits.retract_acceleration.count()});
  std::uint64_t slope = 0x7FFF'FFFF;
  for (const motion::AxisLimits& axis : limits.axes) {
    const std::int32_t most = axis.max_acceleration.count();
    const auto left = static_cast<std::uint64_t>(std::max(most - planned, most / 4));
    const auto speed = static_cast<std::uint64_t>(axis.max_speed.count());
    if (speed == 0) continue;
    slope = std::min(slope, (left << slope_fraction_bits) / (speed * clock.count()));
  }
  return static_cast<std::uint32_t>(std::max<std::uint64_t>(slope, 1));
}

}  // namespace

void Pace::set_limits(const motion::Limits& limits) {
  const std::uint32_t slope = slope_of(limits, clock_);
  step_generator_.set_slopes(slope, slope);
}

std::int32_t Pace::set_speed(std::int32_t percent) {
  if (!step_generator_.stretches_time()) return percent;
  constexpr std::int32_t all = 100;
  const auto slowed = static_cast<std::uint32_t>(std::min(percent, all));
  speed_ = (slowed * one + all / 2) / all;
  set_scale();
  return std::max(percent, all);
}

void Pace::hold(bool held) {
  held_ = held;
  set_scale();
}

void Pace::set_homing(bool homing) {
  if (homing == homing_) return;
  homing_ = homing;
  set_scale();
}

void Pace::set_scale() {
  target_ = held_ ? 0 : homing_ ? one : speed_;
  step_generator_.set_override(target_);
}

units::Microseconds Pace::update(units::Microseconds now, bool moving) {
  const std::int64_t passed = (now - last_).count();
  last_ = now;
  // A scale that changes counts with the mean of its ends. At rest real time passes.
  const std::uint32_t before = scale_;
  if (target_ != one || scale_ != one) scale_ = step_generator_.scale();
  time_ += passed * (moving ? before + scale_ : 2 * one);
  return time();
}

units::Microseconds Pace::time() const { return units::Microseconds(time_ >> time_fraction_bits); }

}  // namespace application
