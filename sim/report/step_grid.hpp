// SPDX-License-Identifier: Apache-2.0
// Between exact positions and whole steps, in integers.
#pragma once

#include <cmath>
#include <cstdint>

#include "sim/report/gcode_path.hpp"

namespace report {

// Steps per millimetre in billionths: what a description or M92 says, without a remainder.
using Resolution = std::int64_t;

inline Resolution resolution_of(double steps_per_mm) {
  return std::llround(steps_per_mm * static_cast<double>(billionths));
}

// value * factor / divisor, rounded to nearest, halves away from zero.
constexpr Femtometers scaled(Femtometers value, Femtometers factor, Femtometers divisor) {
  const Femtometers product = value * factor;
  const Femtometers half = divisor / 2;
  return (product < 0 ? product - half : product + half) / divisor;
}

// The step that is nearest to an exact position.
constexpr std::int64_t nearest_step(Femtometers position, Resolution steps_per_mm) {
  return static_cast<std::int64_t>(scaled(position, steps_per_mm, femtometers_per_mm * billionths));
}

constexpr Femtometers place_of_step(std::int64_t step, Resolution steps_per_mm) {
  return scaled(step, femtometers_per_mm * billionths, steps_per_mm);
}

}  // namespace report
