// SPDX-License-Identifier: Apache-2.0
// Connects a thermistor input to the chip's charge and sense pins.
#pragma once

#include <cstddef>

#include "sim/devices/thermistor_input.hpp"
#include "sim/simulation/clock_rate.hpp"
#include "sim/simulation/device.hpp"

namespace devices {

// Watches sim::OutputPins::sensor_pins(channel).
class SensorChannel : public sim::Device {
 public:
  SensorChannel(std::size_t channel, sim::ClockRate rate, ThermistorInput& input,
                sim::InputPins& pins);

  void pins_changed(sim::Clock now, sim::OutputPins pins, sim::OutputPins changed) override;
  void wake(sim::Clock now) override;
  void set_fault(sim::Clock now, SensorFault fault);
  // 0: it is lost.
  void scale_capacitor(sim::Clock now, double factor);

 private:
  void show(sim::Clock now);

  std::size_t channel_;
  sim::ClockRate rate_;
  ThermistorInput& input_;
  sim::InputPins& pins_;
};

}  // namespace devices
