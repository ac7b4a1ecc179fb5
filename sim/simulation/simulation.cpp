// SPDX-License-Identifier: Apache-2.0
// The event loop between the chip's clocks and the devices.
#include "sim/simulation/simulation.hpp"

#include <algorithm>

namespace sim {

void Simulation::attach(Device& device, OutputPins watched, Activity activity) {
  attachments_.push_back({&device, watched, activity});
}

Clock Simulation::earliest_wake() const {
  Clock earliest = never;
  for (const Attachment& attachment : attachments_) {
    earliest = std::min(earliest, attachment.device->next_wake());
  }
  return earliest;
}

void Simulation::tell_changes(OutputPins changed) {
  const OutputPins pins = chip_.outputs();
  for (const Attachment& attachment : attachments_) {
    if ((attachment.watched.word & changed.word) != 0) {
      const ActivityScope scope(attachment.activity);
      attachment.device->pins_changed(now(), pins, changed);
    }
  }
}

void Simulation::wake_due_devices() {
  for (const Attachment& attachment : attachments_) {
    Device& device = *attachment.device;
    if (device.next_wake_ <= now()) {
      const ActivityScope scope(attachment.activity);
      device.next_wake_ = never;
      device.wake(now());
    }
  }
}

void Simulation::run_until(Clock limit) {
  stopping_ = false;
  while (now() < limit && !stopping_) {
    // A device may have requested a time that has passed (set before it was attached): that is now.
    const Clock wake = std::max(earliest_wake(), now());
    if (wake > now()) chip_.advance(std::min(limit, wake));
    const OutputPins changed{chip_.outputs().word ^ previous_.word};
    if (changed.word != 0) {
      previous_ = chip_.outputs();
      tell_changes(changed);
    }
    if (wake <= now()) wake_due_devices();
  }
}

}  // namespace sim
