// SPDX-License-Identifier: Apache-2.0
// What the netlist's pins must be, given the model's.
#include "tests/netlist/netlist_twin.hpp"

#include <algorithm>

namespace tests {

namespace {

// output_register of boards/ulx3s/ulx3s.vhd, drive_pins of boards/cyclone/cyclone_board.vhd.
constexpr sim::OutputPins pins_with_registers() {
  using sim::OutputPins;
  constexpr std::uint64_t axes = (std::uint64_t{1} << sim::axis_count) - 1;
  constexpr std::uint64_t heaters = (std::uint64_t{1} << sim::heater_count) - 1;
  return {axes << OutputPins::step_bit | axes << OutputPins::direction_bit |
          axes << OutputPins::enable_bit | heaters << OutputPins::heater_bit |
          std::uint64_t{1} << OutputPins::fan_bit};
}

}  // namespace

NetlistTwin::NetlistTwin(std::uint32_t clock_hz)
    : Twins(model_, netlist_), model_(clock_hz), earlier_(model_.outputs()) {
  compare();
}

// To the first clock in which a pin of the model changes, or to the one after it.
void NetlistTwin::advance(sim::Clock limit) {
  earlier_ = model_.outputs();
  const bool changed = ((earlier_.word ^ outputs_.word) & pins_with_registers().word) != 0;
  Twins::advance(changed ? std::min(limit, now_ + 1) : limit);
}

// A pin that is left open has no level on the board.
sim::OutputPins NetlistTwin::expected_outputs() const {
  constexpr std::uint64_t registered = pins_with_registers().word;
  sim::OutputPins pins{(earlier_.word & registered) | (model_.outputs().word & ~registered)};
  for (unsigned channel = 0; channel < sim::sensor_count; ++channel) {
    const std::uint64_t left_open = ~std::uint64_t{pins.sensor_drive(channel)} & 7;
    pins.word &= ~(left_open << (sim::OutputPins::sensor_bit + 8 * channel +
                                 sim::OutputPins::sensor_level_bit));
  }
  return pins;
}

}  // namespace tests
