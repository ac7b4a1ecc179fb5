// SPDX-License-Identifier: Apache-2.0
// What the temperature converter says about a sensor: its newest conversion, still in clocks.
#pragma once

#include <cstdint>

#include "units/quantity.hpp"

namespace thermal {

// Outcomes of a conversion; the names are those of the hardware's status register.
enum class SensorState : std::uint8_t { never, ok, open, shorted, stuck, time_out };

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
