// SPDX-License-Identifier: Apache-2.0
// A stepper driver chip such as the A4988: takes steps whose timing keeps its data
// sheet, loses others.
#pragma once

#include <vector>

#include "sim/devices/step_edge.hpp"
#include "sim/plants/axis.hpp"
#include "sim/simulation/activity.hpp"
#include "sim/simulation/clock_rate.hpp"
#include "sim/simulation/device.hpp"

namespace devices {

struct DriverTiming {
  std::uint64_t high_ns{};
  std::uint64_t low_ns{};
  std::uint64_t direction_setup_ns{};
  std::uint64_t direction_hold_ns{};
};

struct PulseCounts {
  std::uint64_t forward{};  // all rising edges with the direction pin low
  std::uint64_t backward{};
  std::uint64_t illegal{};  // pulses that broke the timing; their steps are lost
  std::uint64_t disabled{};  // pulses while the driver was off; their steps are lost
  sim::Clock shortest_interval = sim::never;  // between rising edges
};

// Direction low moves the axis away from its end stop.
class MotorDriver : public sim::Device {
 public:
  MotorDriver(std::size_t axis_index, const DriverTiming& timing, sim::ClockRate rate,
              plants::Axis& axis);

  // A profile counts its time as `activity`.
  void add_listener(StepListener& listener, sim::Activity activity = sim::Activity::devices) {
    listeners_.push_back({&listener, activity});
  }
  void pins_changed(sim::Clock now, sim::OutputPins pins, sim::OutputPins changed) override;

  const PulseCounts& counts() const { return counts_; }
  const plants::Axis& axis() const { return axis_; }
  std::size_t axis_index() const { return axis_index_; }
  bool enabled() const { return enabled_; }

 private:
  struct Listening {
    StepListener* listener;
    sim::Activity activity;
  };

  void change_direction(sim::Clock now, bool backward);
  void rise(sim::Clock now);
  void fall(sim::Clock now);
  void take_back_step();

  std::size_t axis_index_;
  sim::ClockRate rate_;
  plants::Axis& axis_;
  sim::Clock high_, low_, direction_setup_, direction_hold_;
  std::vector<Listening> listeners_;
  PulseCounts counts_;
  bool enabled_ = false;
  int direction_ = 1;
  bool step_taken_ = false;  // by the last rising edge
  bool any_rise_ = false, any_fall_ = false, any_direction_change_ = false;
  sim::Clock rose_at_ = 0, fell_at_ = 0, direction_changed_at_ = 0;
  int last_step_direction_ = 0;
};

}  // namespace devices
