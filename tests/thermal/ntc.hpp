// SPDX-License-Identifier: Apache-2.0
// The sensor that the tests of the thermal logic use: a 100 kOhm NTC at the usual circuit.
#pragma once

#include "thermal/sensor.hpp"

namespace tests {

inline constexpr thermal::ThermistorTable ntc_table({units::Milliohms(100'000'000), 4066});
inline constexpr thermal::ReferenceResistors references{units::Milliohms(470'000),
                                                        units::Milliohms(10'000'000)};
inline constexpr std::uint32_t picoseconds_per_ohm =
    thermal::picoseconds_per_ohm(68'000, 3.3, 1.65);

constexpr units::Millicelsius celsius(double degrees) {
  return units::Millicelsius(static_cast<std::int32_t>(degrees * 1000.0));
}

}  // namespace tests
