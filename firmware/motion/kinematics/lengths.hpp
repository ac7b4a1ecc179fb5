// SPDX-License-Identifier: Apache-2.0
// Lengths of lines between places of the tool, each coordinate up to 1 m apart.
#pragma once

#include <cstdint>

#include "motion/kinematics/kinematics.hpp"
#include "motion/scaled.hpp"
#include "units/magnitude.hpp"

namespace motion::kinematics {

// |value| < 2^32
constexpr std::uint64_t square(std::int64_t value) {
  const std::uint64_t size = units::magnitude(value);
  return size * size;
}

// nm; in X and Y, rounded, and in space.
std::uint32_t horizontal_length(const Place& from, const Place& to);
Scaled spatial_length(const Place& from, const Place& to);

}  // namespace motion::kinematics
