// SPDX-License-Identifier: Apache-2.0
// Averages the fan pin over intervals.
#include "sim/devices/fan_gate.hpp"

#include <cmath>

namespace devices {

namespace {
constexpr double interval_seconds = 0.1;
constexpr double speed_steps = 64.0;  // finer ones change no temperature that matters
}  // namespace

FanGate::FanGate(sim::ClockRate rate, SpeedListener listener)
    : rate_(rate), listener_(std::move(listener)) {
  next_wake_ = rate_.clocks(interval_seconds);
}

void FanGate::pins_changed(sim::Clock now, sim::OutputPins pins, sim::OutputPins) {
  if (on_) clocks_on_ += now - on_since_;
  on_ = pins.fan();
  on_since_ = now;
}

void FanGate::wake(sim::Clock now) {
  next_wake_ = now + rate_.clocks(interval_seconds);
  if (on_) {
    clocks_on_ += now - on_since_;
    on_since_ = now;
  }
  const double share = static_cast<double>(clocks_on_) / static_cast<double>(now - interval_start_);
  clocks_on_ = 0;
  interval_start_ = now;
  const double speed = std::round(share * speed_steps) / speed_steps;
  if (speed != speed_) {
    speed_ = speed;
    listener_(rate_.seconds(now), speed);
  }
}

}  // namespace devices
