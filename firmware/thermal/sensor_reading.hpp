// SPDX-License-Identifier: Apache-2.0
// The newest conversion of a sensor by the temperature converter, in clocks.
#pragma once

#include <cstdint>

#include "registers/temperature_converter_registers.hpp"
#include "units/quantity.hpp"

namespace thermal {

// Outcomes of a conversion.
using SensorState = registers::temperature_converter::Status::State;

// Counts are sums over all charges of one conversion, in clocks; small is hot.
struct SensorReading {
  SensorState state{};
  std::uint8_t conversions{};  // modulo 256: differs from the last one if this is a new conversion
  std::uint32_t thermistor{};
  std::uint32_t reference_low{};  // 0 without reference resistors
  std::uint32_t reference_high{};
  units::Milliseconds age{};
};

// The thermistor counts between which a heater may be on.
struct CountLimits {
  std::uint32_t minimum{};  // at the highest temperature
  std::uint32_t maximum{};  // at the lowest temperature
};

}  // namespace thermal
