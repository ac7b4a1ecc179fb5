// SPDX-License-Identifier: Apache-2.0
// What the netlist's pins must be, given the model's.
#include "tests/netlist/netlist_twin.hpp"

namespace tests {

NetlistTwin::NetlistTwin(std::uint32_t clock_hz) : Twins(model_, netlist_), model_(clock_hz) {
  compare();
}

// A pin that is left open has no level on the board.
sim::OutputPins NetlistTwin::expected_outputs() const {
  sim::OutputPins pins = model_.outputs();
  for (unsigned channel = 0; channel < sim::sensor_count; ++channel) {
    const std::uint64_t left_open = ~std::uint64_t{pins.sensor_drive(channel)} & 7;
    pins.word &= ~(left_open << (sim::OutputPins::sensor_bit + 8 * channel +
                                 sim::OutputPins::sensor_level_bit));
  }
  return pins;
}

}  // namespace tests
