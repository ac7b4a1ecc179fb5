// SPDX-License-Identifier: Apache-2.0
// A device connected to the chip: it is called when a pin that it watches changes, or when
// its time comes.
#pragma once

#include "sim/simulation/pins.hpp"

namespace sim {

// A device changes input pins through a reference to InputPins that it is given when it is made,
// and asks to be called again by setting `next_wake_`. Nothing is called in between, so idle
// devices cost nothing.
class Device {
 public:
  Device() = default;
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;
  virtual ~Device() = default;

  // At least one watched output differs from before; `changed` has a 1 for every
  // output that differs.
  virtual void pins_changed([[maybe_unused]] Clock now, [[maybe_unused]] OutputPins pins,
                            [[maybe_unused]] OutputPins changed) {}
  // The clock `next_wake()` has come. It is set to `never` before the call.
  virtual void wake([[maybe_unused]] Clock now) {}

  Clock next_wake() const { return next_wake_; }

 protected:
  Clock next_wake_ = never;

 private:
  friend class Simulation;
};

}  // namespace sim
