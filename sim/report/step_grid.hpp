// SPDX-License-Identifier: Apache-2.0
// Between exact positions and whole steps, in integers.
#pragma once

#include <cmath>
#include <cstdint>

#include "sim/report/gcode_path.hpp"

namespace report {

// Steps per millimetre in millionths: what a description or M92 says, without a remainder.
using Resolution = std::int64_t;

inline Resolution resolution_of(double steps_per_mm) {
  return std::llround(steps_per_mm * static_cast<double>(millionths));
}

// value * factor / divisor, rounded to nearest, halves away from zero.
constexpr std::int64_t scaled(std::int64_t value, std::int64_t factor, std::int64_t divisor) {
  __extension__ using Wide = __int128;
  const Wide product = static_cast<Wide>(value) * factor;
  const Wide half = divisor / 2;
  return static_cast<std::int64_t>((product < 0 ? product - half : product + half) / divisor);
}

// The step that is nearest to an exact position.
constexpr std::int64_t nearest_step(Picometers position, Resolution steps_per_mm) {
  return scaled(position, steps_per_mm, picometers_per_mm * millionths);
}

constexpr Picometers place_of_step(std::int64_t step, Resolution steps_per_mm) {
  return scaled(step, picometers_per_mm * millionths, steps_per_mm);
}

}  // namespace report
