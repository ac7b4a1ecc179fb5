// SPDX-License-Identifier: Apache-2.0
// Records every rising edge of the step pins with its clock, and the shortest times on step
// and direction.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "sim/simulation/device.hpp"

namespace benchmarks {

inline constexpr std::size_t axes = 4;

class PinWatch : public sim::Device {
 public:
  struct Axis {
    std::vector<sim::Clock> rises;
    sim::Clock shortest_high = sim::never;
    sim::Clock shortest_low = sim::never;
    sim::Clock shortest_setup = sim::never;
    sim::Clock shortest_hold = sim::never;
  };

  void pins_changed(sim::Clock now, sim::OutputPins pins, sim::OutputPins changed) override {
    for (std::size_t i = 0; i < axes; ++i) {
      if (changed.direction(i)) turn(i, now);
      if (changed.step(i)) pins.step(i) ? rise(i, now) : fall(i, now);
    }
  }

  static constexpr sim::OutputPins watched() {
    sim::OutputPins pins;
    for (std::size_t i = 0; i < axes; ++i) pins.word |= sim::OutputPins::motor_pins(i).word;
    return pins;
  }

  const Axis& axis(std::size_t index) const { return axes_[index]; }

 private:
  struct Times {
    sim::Clock fell = sim::never, turned = sim::never;
  };

  static void lessen(sim::Clock& shortest, sim::Clock since, sim::Clock now) {
    if (since != sim::never) shortest = std::min(shortest, now - since);
  }
  void turn(std::size_t i, sim::Clock now) {
    if (!axes_[i].rises.empty()) lessen(axes_[i].shortest_hold, axes_[i].rises.back(), now);
    times_[i].turned = now;
  }
  void rise(std::size_t i, sim::Clock now) {
    lessen(axes_[i].shortest_low, times_[i].fell, now);
    lessen(axes_[i].shortest_setup, times_[i].turned, now);
    axes_[i].rises.push_back(now);
  }
  void fall(std::size_t i, sim::Clock now) {
    lessen(axes_[i].shortest_high, axes_[i].rises.back(), now);
    times_[i].fell = now;
  }

  std::array<Axis, axes> axes_{};
  std::array<Times, axes> times_{};
};

}  // namespace benchmarks
