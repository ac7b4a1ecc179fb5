// SPDX-License-Identifier: Apache-2.0
// The rotor's equation of motion, integrated between steps.
#include "sim/plants/axis.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plants {

Axis::Axis(const AxisProperties& properties, std::int64_t position)
    : properties_(properties), position_(position) {
  const double field_period = 4.0 * static_cast<double>(properties.microsteps_per_full_step);
  const double natural_frequency =
      std::sqrt(properties.torque_acceleration * 2.0 * std::numbers::pi / field_period);
  const double damping = properties.torque_acceleration / properties.speed_limit;
  longest_interval_ = std::min(0.15 / natural_frequency, 0.5 / damping);
  settle_seconds_ = 10.0 / damping;
}

void Axis::step(double seconds, int direction) {
  const double pause = seconds - last_step_seconds_;
  last_step_seconds_ = seconds;
  if (pause > settle_seconds_) {
    lag_ = 0;
    speed_ = 0;
  } else {
    let_rotor_follow(pause);
  }
  const std::int64_t next = position_ + direction;
  if ((properties_.lower_frame && next < *properties_.lower_frame) ||
      (properties_.upper_frame && next > *properties_.upper_frame)) {
    ++frame_steps_;
    lag_ = 0;
    speed_ = 0;
    return;
  }
  position_ = next;
  lag_ -= direction;
  slip_if_left_behind();
}

void Axis::undo_step(int direction) {
  position_ -= direction;
  lag_ += direction;
}

void Axis::release() {
  lag_ = 0;
  speed_ = 0;
}

// Semi-implicit Euler, which keeps the energy of the oscillation.
void Axis::let_rotor_follow(double duration) {
  const double field_period = 4.0 * static_cast<double>(properties_.microsteps_per_full_step);
  const double angle_per_step = 2.0 * std::numbers::pi / field_period;
  const double damping = properties_.torque_acceleration / properties_.speed_limit;
  const double intervals = std::ceil(duration / longest_interval_);
  const double interval = intervals > 0 ? duration / intervals : 0;
  for (int i = 0; i < static_cast<int>(intervals); ++i) {
    const double torque = -properties_.torque_acceleration * std::sin(lag_ * angle_per_step);
    speed_ += (torque - damping * speed_) * interval;
    lag_ += speed_ * interval;
    slip_if_left_behind();
  }
}

void Axis::slip_if_left_behind() {
  const std::int64_t half_period = 2 * properties_.microsteps_per_full_step;
  const double load = std::abs(lag_) / static_cast<double>(half_period);
  peak_load_ = std::max(peak_load_, std::min(load, 1.0));
  if (load <= 1.0) return;
  const std::int64_t lost = lag_ < 0 ? 2 * half_period : -2 * half_period;
  position_ -= lost;
  lag_ += static_cast<double>(lost);
  slipped_steps_ += static_cast<std::uint64_t>(2 * half_period);
}

}  // namespace plants
