// SPDX-License-Identifier: Apache-2.0
// The transistor behind a heater pin of the chip, the relay before all of them, and the heater in
// its block.
#pragma once

#include "sim/plants/heated_block.hpp"
#include "sim/simulation/clock_rate.hpp"
#include "sim/simulation/device.hpp"

namespace devices {

class HeaterGate : public sim::Device {
 public:
  HeaterGate(std::size_t channel, sim::ClockRate rate, plants::HeatedBlock& block)
      : channel_(channel), rate_(rate), block_(block) {
    // Held open by its pull-down until the chip closes it.
    block_.set_supply(0, false);
  }

  void pins_changed(sim::Clock now, sim::OutputPins pins, sim::OutputPins) override {
    block_.set_supply(rate_.seconds(now), pins.heater_supply());
    block_.set_heater(rate_.seconds(now), pins.heater(channel_));
  }

 private:
  std::size_t channel_;
  sim::ClockRate rate_;
  plants::HeatedBlock& block_;
};

}  // namespace devices
