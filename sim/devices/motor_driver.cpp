// SPDX-License-Identifier: Apache-2.0
// Timing checks of a stepper driver on the clock grid.
#include "sim/devices/motor_driver.hpp"

#include <algorithm>

namespace devices {

MotorDriver::MotorDriver(std::size_t axis_index, const DriverTiming& timing, sim::ClockRate rate,
                         plants::Axis& axis)
    : axis_index_(axis_index),
      rate_(rate),
      axis_(axis),
      high_(rate.clocks_covering_ns(timing.high_ns)),
      low_(rate.clocks_covering_ns(timing.low_ns)),
      direction_setup_(rate.clocks_covering_ns(timing.direction_setup_ns)),
      direction_hold_(rate.clocks_covering_ns(timing.direction_hold_ns)) {}

void MotorDriver::pins_changed(sim::Clock now, sim::OutputPins pins, sim::OutputPins changed) {
  if (changed.enable(axis_index_)) {
    enabled_ = pins.enable(axis_index_);
    if (!enabled_) axis_.release();
  }
  // The driver sees both change at once: a rising step pin samples a direction without set-up time.
  if (changed.direction(axis_index_)) change_direction(now, pins.direction(axis_index_));
  if (changed.step(axis_index_)) {
    if (pins.step(axis_index_)) {
      rise(now);
    } else {
      fall(now);
    }
  }
}

void MotorDriver::change_direction(sim::Clock now, bool backward) {
  direction_ = backward ? -1 : 1;
  direction_changed_at_ = now;
  any_direction_change_ = true;
  if (any_rise_ && now - rose_at_ < direction_hold_) take_back_step();
}

void MotorDriver::rise(sim::Clock now) {
  ++(direction_ > 0 ? counts_.forward : counts_.backward);
  if (any_rise_) counts_.shortest_interval = std::min(counts_.shortest_interval, now - rose_at_);
  const bool low_too_short = any_fall_ && now - fell_at_ < low_;
  const bool setup_too_short =
      any_direction_change_ && now - direction_changed_at_ < direction_setup_;
  rose_at_ = now;
  any_rise_ = true;
  last_step_direction_ = direction_;
  step_taken_ = false;
  if (low_too_short || setup_too_short) {
    ++counts_.illegal;
  } else if (!enabled_) {
    ++counts_.disabled;
  } else {
    axis_.step(rate_.seconds(now), direction_);
    step_taken_ = true;
  }
  for (const auto& [listener, activity] : listeners_) {
    const sim::ActivityScope scope(activity);
    listener->stepped({now, axis_index_, direction_, axis_.position()});
  }
}

void MotorDriver::fall(sim::Clock now) {
  fell_at_ = now;
  any_fall_ = true;
  if (now - rose_at_ < high_) take_back_step();
}

// A violation after the rising edge makes that pulse illegal, once, and its step is lost.
void MotorDriver::take_back_step() {
  if (!step_taken_) return;
  step_taken_ = false;
  ++counts_.illegal;
  axis_.undo_step(last_step_direction_);
}

}  // namespace devices
