// SPDX-License-Identifier: Apache-2.0
// The temperature converter: settings of its conversions and the newest reading of each sensor.
#pragma once

#include <cstddef>
#include <cstdint>

#include "thermal/sensor_reading.hpp"
#include "units/quantity.hpp"

namespace drivers {

struct ConverterSettings {
  bool references = true;  // the two reference resistors are there
  std::uint32_t charges = 16;  // per resistor and conversion, 1 to 256
  units::Microseconds discharge{};  // before each charge
  units::Microseconds longest_charge{};  // then it is a time-out; at most 125 ms
  units::Microseconds pause{};  // between conversions
  std::uint8_t dither_cycles = 1;
  std::uint32_t short_limit{};  // a smaller thermistor count is a short
};

class TemperatureConverter {
 public:
  // Clocks between a pin's edge and its effect in the count: what each charge counts too many.
  static constexpr std::uint32_t delay_cycles = 2;

  explicit constexpr TemperatureConverter(units::Hertz clock) : clock_(clock) {}

  // Starts to convert all channels, without end. Once a limit of a heater is locked the settings
  // stay what they were.
  void start(const ConverterSettings& settings);
  // All pins high-impedance.
  void stop();
  // A change of the locked settings was refused.
  bool refused_settings() const;

  thermal::SensorReading reading(std::size_t channel) const;

 private:
  units::Hertz clock_;
};

}  // namespace drivers
