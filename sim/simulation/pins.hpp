// SPDX-License-Identifier: Apache-2.0
// The chip's pins as seen from outside: one word of outputs, one struct of inputs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

namespace sim {

// Rising clock edges since the start of the simulation. Outputs seen at `now` were set by edge
// number `now`; an input set at `now` is sampled by edge number `now + 1`.
using Clock = std::uint64_t;
inline constexpr Clock never = std::numeric_limits<Clock>::max();

inline constexpr std::size_t axis_count = 5;  // x y z e0 e1
inline constexpr std::size_t sensor_count = 2;  // of the default chip: hotend, bed
inline constexpr std::size_t heater_count = 2;
// Of each, where there is a second hotend.
inline constexpr std::size_t most_heaters = 3;
inline constexpr std::size_t end_stop_count = 8;

// The three resistors of a sensor channel through which the chip charges its capacitor, in the
// order of the bits of sensor_drive() and sensor_level().
enum class SensorResistor : std::uint8_t { thermistor, reference_low, reference_high };

// All outputs in one word, so that one comparison shows whether any has changed.
struct OutputPins {
  std::uint64_t word{};

  static constexpr unsigned step_bit = 0;
  static constexpr unsigned direction_bit = 8;
  static constexpr unsigned enable_bit = 16;
  static constexpr unsigned transmit_bit = 24;
  static constexpr unsigned fan_bit = 25;
  static constexpr unsigned heater_bit = 26;
  static constexpr unsigned fault_bit = 30;
  static constexpr unsigned jtag_bit = 31;
  static constexpr unsigned sensor_bit =
      32;  // channel n: 8 bits from here + 8 n: 3 drive, 3 level; at most 3 of them
  static constexpr unsigned sensor_level_bit = 3;
  static constexpr unsigned heater_supply_bit = 63;

  static constexpr std::uint64_t bit(unsigned position) { return std::uint64_t{1} << position; }
  static constexpr OutputPins motor_pins(std::size_t axis) {
    const auto shift = static_cast<unsigned>(axis);
    return {bit(step_bit + shift) | bit(direction_bit + shift) | bit(enable_bit + shift)};
  }
  static constexpr OutputPins sensor_pins(std::size_t channel) {
    return {std::uint64_t{0x3f} << (sensor_bit + 8 * static_cast<unsigned>(channel))};
  }
  static constexpr OutputPins heater_pin(std::size_t channel) {
    return {bit(heater_bit + static_cast<unsigned>(channel))};
  }
  static constexpr OutputPins heater_supply_pin() { return {bit(heater_supply_bit)}; }
  static constexpr OutputPins transmit_pin() { return {bit(transmit_bit)}; }
  static constexpr OutputPins fan_pin() { return {bit(fan_bit)}; }
  static constexpr OutputPins jtag_pin() { return {bit(jtag_bit)}; }

  constexpr bool at(unsigned position) const { return (word >> position & 1) != 0; }
  constexpr bool step(std::size_t axis) const { return at(step_bit + static_cast<unsigned>(axis)); }
  constexpr bool direction(std::size_t axis) const {
    return at(direction_bit + static_cast<unsigned>(axis));
  }
  constexpr bool enable(std::size_t axis) const {
    return at(enable_bit + static_cast<unsigned>(axis));
  }
  constexpr bool transmit() const { return at(transmit_bit); }
  constexpr bool fan() const { return at(fan_bit); }
  constexpr bool heater(std::size_t channel) const {
    return at(heater_bit + static_cast<unsigned>(channel));
  }
  constexpr bool heater_supply() const { return at(heater_supply_bit); }
  constexpr bool fault() const { return at(fault_bit); }
  constexpr bool jtag_data() const { return at(jtag_bit); }  // TDO
  // Bit n = SensorResistor n: 1 where the chip drives that pin; its level is in sensor_level().
  constexpr std::uint8_t sensor_drive(std::size_t channel) const {
    return static_cast<std::uint8_t>(word >> (sensor_bit + 8 * channel) & 7);
  }
  constexpr std::uint8_t sensor_level(std::size_t channel) const {
    return static_cast<std::uint8_t>(word >> (sensor_bit + sensor_level_bit + 8 * channel) & 7);
  }

  constexpr bool operator==(const OutputPins&) const = default;
};

// Of no effect in a model of the chip without debugging.
struct JtagPins {
  bool tck{};
  bool tms = true;
  bool tdi{};

  constexpr bool operator==(const JtagPins&) const = default;
};

struct InputPins {
  bool receive = true;  // serial line, idle high
  std::uint8_t end_stops{};  // bit n = switch n, 1 = triggered
  std::uint8_t sense{};  // bit n = capacitor of sensor channel n is above the threshold
  bool emergency_stop{};  // 1 = its circuit, normally closed to ground, is open
  JtagPins jtag;

  constexpr bool operator==(const InputPins&) const = default;
};

}  // namespace sim
