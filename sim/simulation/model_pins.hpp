// SPDX-License-Identifier: Apache-2.0
// Pins and counters that all models of the chip have. Templates: models share no base.
#pragma once

#include <cstdint>

#include "sim/simulation/chip.hpp"

namespace sim {

template <class Model>
void set_input_pins(Model& model, const InputPins& inputs) {
  model.receive = inputs.receive;
  model.end_stop = inputs.end_stops;
  model.sensor_sense = inputs.sense;
  model.emergency_stop = inputs.emergency_stop;
  model.tck = inputs.jtag.tck;
  model.tms = inputs.jtag.tms;
  model.tdi = inputs.jtag.tdi;
}

template <class Model>
OutputPins sampled_output_pins(const Model& model) {
  constexpr unsigned channel_pins = 3, channel_mask = 7;
  std::uint64_t word = std::uint64_t{model.step} << OutputPins::step_bit |
                       std::uint64_t{model.direction} << OutputPins::direction_bit |
                       std::uint64_t{model.motor_enable} << OutputPins::enable_bit |
                       std::uint64_t{model.transmit} << OutputPins::transmit_bit |
                       std::uint64_t{model.fan_gate} << OutputPins::fan_bit |
                       std::uint64_t{model.heater_gate} << OutputPins::heater_bit |
                       std::uint64_t{model.heater_supply} << OutputPins::heater_supply_bit |
                       std::uint64_t{model.fault} << OutputPins::fault_bit |
                       std::uint64_t{model.tdo} << OutputPins::jtag_bit;
  for (unsigned channel = 0; channel < most_heaters; ++channel) {
    const std::uint64_t drive =
        model.sensor_drive_enable >> (channel_pins * channel) & channel_mask;
    const std::uint64_t level = model.sensor_drive_level >> (channel_pins * channel) & channel_mask;
    word |= (drive | level << OutputPins::sensor_level_bit)
            << (OutputPins::sensor_bit + 8 * channel);
  }
  return {word};
}

template <class Root>
QueueStatistics sampled_queue_statistics(const Root& root) {
  return {root.printer_core__DOT__motion__DOT__generator__DOT__core__DOT__underruns,
          root.printer_core__DOT__motion__DOT__generator__DOT__core__DOT__stalls,
          root.printer_core__DOT__motion__DOT__generator__DOT__core__DOT__level,
          root.printer_core__DOT__motion__DOT__generator__DOT__core__DOT__max_level};
}

}  // namespace sim
