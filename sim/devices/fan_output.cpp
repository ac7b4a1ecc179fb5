// SPDX-License-Identifier: Apache-2.0
// The part cooling fan on its pin: turns as fast as it is switched on, with inertia, and cools the
// hotend.
#include "sim/devices/fan_output.hpp"

#include <utility>

namespace devices {
namespace {

constexpr double interval_seconds = 0.1;
constexpr double inertia_intervals = 5;
constexpr double negligible = 1e-3;

}  // namespace

FanOutput::FanOutput(sim::ClockRate rate, std::function<void(double)> cool)
    : rate_(rate), cool_(std::move(cool)) {
  next_wake_ = rate_.clocks(interval_seconds);
}

void FanOutput::count_until(sim::Clock now) {
  if (on_) on_clocks_ += now - counted_until_;
  counted_until_ = now;
}

void FanOutput::pins_changed(sim::Clock now, sim::OutputPins pins, sim::OutputPins) {
  count_until(now);
  on_ = pins.fan();
}

void FanOutput::wake(sim::Clock now) {
  count_until(now);
  const double mean = rate_.seconds(on_clocks_) / interval_seconds;
  on_clocks_ = 0;
  next_wake_ = now + rate_.clocks(interval_seconds);
  const double difference = mean - speed_;
  if (difference > -negligible && difference < negligible) return;
  speed_ += difference / inertia_intervals;
  cool_(speed_);
}

}  // namespace devices
