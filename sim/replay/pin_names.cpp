// SPDX-License-Identifier: Apache-2.0
// Each bit of the word of outputs belongs to a pin, or to none.
#include "sim/replay/pin_names.hpp"

#include <fmt/format.h>

#include <bit>

#include "sim/simulation/pins.hpp"

namespace replay {

namespace {

using sim::OutputPins;

// Of several pins in a row.
struct PinGroup {
  std::uint64_t pins;
  const char* name;
};

constexpr PinGroup group(unsigned first, unsigned count, const char* name) {
  return {((std::uint64_t{1} << count) - 1) << first, name};
}

std::array<PinGroup, 9> groups() {
  constexpr unsigned axes = sim::axis_count;
  return {group(OutputPins::step_bit, axes, "step"),
          group(OutputPins::direction_bit, axes, "direction"),
          group(OutputPins::enable_bit, axes, "motor_enable"),
          group(OutputPins::transmit_bit, 1, "transmit"),
          group(OutputPins::fan_bit, 1, "fan_gate"),
          group(OutputPins::heater_bit, sim::heater_count, "heater_gate"),
          group(OutputPins::heater_supply_bit, 1, "heater_supply"),
          group(OutputPins::fault_bit, 1, "fault"),
          group(OutputPins::jtag_bit, 1, "tdo")};
}

}  // namespace

std::string pin_names(std::uint64_t pins) {
  std::string names;
  const auto add = [&](const std::string& name) { names += (names.empty() ? "" : " ") + name; };
  for (const PinGroup& group : groups()) {
    for (std::uint64_t left = pins & group.pins; left != 0; left &= left - 1) {
      add(std::popcount(group.pins) == 1
              ? group.name
              : fmt::format("{}({})", group.name,
                            std::countr_zero(left) - std::countr_zero(group.pins)));
    }
    pins &= ~group.pins;
  }
  for (std::size_t channel = 0; channel < sim::sensor_count; ++channel) {
    const std::uint64_t sensor = OutputPins::sensor_pins(channel).word;
    if ((pins & sensor) != 0) add(fmt::format("sensor_drive({})", channel));
    pins &= ~sensor;
  }
  if (pins != 0) add(fmt::format("{:#x}", pins));
  return names;
}

}  // namespace replay
