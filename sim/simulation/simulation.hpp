// SPDX-License-Identifier: Apache-2.0
// Runs the chip and the devices around it on one time scale, in clocks.
#pragma once

#include <vector>

#include "sim/simulation/activity.hpp"
#include "sim/simulation/chip.hpp"
#include "sim/simulation/clock_rate.hpp"
#include "sim/simulation/device.hpp"

namespace sim {

class Simulation {
 public:
  Simulation(Chip& chip, ClockRate rate) : chip_(chip), rate_(rate), previous_(chip.outputs()) {}

  // `device` is called on changes of the output pins that are 1 in `watched`, in the order of
  // attaching. It must outlive the simulation's last run. A profile counts its time as `activity`.
  void attach(Device& device, OutputPins watched, Activity activity = Activity::devices);

  // Runs until `limit`, or until a device has called stop().
  void run_until(Clock limit);
  // Ends the current run_until() at the present clock.
  void stop() { stopping_ = true; }

  Clock now() const { return chip_.now(); }
  double seconds() const { return rate_.seconds(now()); }
  ClockRate rate() const { return rate_; }
  Chip& chip() { return chip_; }

 private:
  struct Attachment {
    Device* device;
    OutputPins watched;
    Activity activity;
  };

  Clock earliest_wake() const;
  void tell_changes(OutputPins changed);
  void wake_due_devices();

  Chip& chip_;
  ClockRate rate_;
  OutputPins previous_;
  std::vector<Attachment> attachments_;
  bool stopping_ = false;
};

}  // namespace sim
