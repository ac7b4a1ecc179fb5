// SPDX-License-Identifier: Apache-2.0
// The part cooling fan: its inertia makes one speed of the pulses on its pin.
#pragma once

#include <functional>

#include "sim/simulation/clock_rate.hpp"
#include "sim/simulation/device.hpp"

namespace devices {

class FanGate : public sim::Device {
 public:
  // Called at intervals, where it has changed: 0 to 1.
  using SpeedListener = std::function<void(double seconds, double speed)>;

  FanGate(sim::ClockRate rate, SpeedListener listener);

  void pins_changed(sim::Clock now, sim::OutputPins pins, sim::OutputPins changed) override;
  void wake(sim::Clock now) override;

  double speed() const { return speed_; }

 private:
  sim::ClockRate rate_;
  SpeedListener listener_;
  bool on_ = false;
  sim::Clock on_since_ = 0;
  sim::Clock clocks_on_ = 0;  // in this interval
  sim::Clock interval_start_ = 0;
  double speed_ = 0;
};

}  // namespace devices
