// SPDX-License-Identifier: Apache-2.0
// Keeps model and netlist at one time with the same inputs, and compares what they drive.
#include "tests/netlist/netlist_twin.hpp"

#include <fmt/format.h>

namespace tests {

namespace {

// A pin that is left open has no level on the board.
sim::OutputPins as_driven(sim::OutputPins pins) {
  for (unsigned channel = 0; channel < sim::sensor_count; ++channel) {
    const std::uint64_t left_open = ~std::uint64_t{pins.sensor_drive(channel)} & 7;
    pins.word &= ~(left_open << (sim::OutputPins::sensor_bit + 8 * channel +
                                 sim::OutputPins::sensor_level_bit));
  }
  return pins;
}

}  // namespace

NetlistTwin::NetlistTwin(std::uint32_t clock_hz) : model_(clock_hz) { compare(); }

void NetlistTwin::compare() {
  now_ = model_.now();
  outputs_ = as_driven(model_.outputs());
  if (netlist_.now() != now_ || netlist_.outputs() != outputs_) {
    throw PinsDiffer(
        fmt::format("the model's pins are {:#x} at clock {}, the netlist's {:#x} at {}",
                    outputs_.word, now_, netlist_.outputs().word, netlist_.now()));
  }
}

void NetlistTwin::advance(sim::Clock limit) {
  model_.inputs() = inputs_;
  netlist_.inputs() = inputs_;
  model_.advance(limit);
  // Returns earlier where its pins change earlier.
  netlist_.advance(model_.now());
  compare();
}

void NetlistTwin::reset() { netlist_.reset(); }

std::uint32_t NetlistTwin::read_memory(std::uint32_t address) const {
  return model_.read_memory(address);
}

void NetlistTwin::write_memory(std::uint32_t address, std::uint32_t word) {
  model_.write_memory(address, word);
}

}  // namespace tests
