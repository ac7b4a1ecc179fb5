// SPDX-License-Identifier: Apache-2.0
// The part cooling fan on its pin: turns as fast as it is switched on, with inertia, and cools the
// hotend.
#pragma once

#include <functional>

#include "sim/simulation/clock_rate.hpp"
#include "sim/simulation/device.hpp"

namespace devices {

// Watches sim::OutputPins::fan_pin(). The speed follows the mean of the pin over a tenth of a
// second.
class FanOutput : public sim::Device {
 public:
  // `cool` is told the speed when it changes: 0 to 1.
  FanOutput(sim::ClockRate rate, std::function<void(double)> cool);

  void pins_changed(sim::Clock now, sim::OutputPins pins, sim::OutputPins changed) override;
  void wake(sim::Clock now) override;
  double speed() const { return speed_; }  // 0 to 1

 private:
  void count_until(sim::Clock now);

  sim::ClockRate rate_;
  std::function<void(double)> cool_;
  bool on_ = false;
  sim::Clock counted_until_ = 0;
  sim::Clock on_clocks_ = 0;  // of the present interval
  double speed_ = 0;
};

}  // namespace devices
