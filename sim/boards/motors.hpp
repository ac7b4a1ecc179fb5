// SPDX-License-Identifier: Apache-2.0
// Motors' pins of a board as the simulated printer's drivers take them: X Y Z E0 E1.
#pragma once

#include <cstdint>

#include "sim/simulation/pins.hpp"
#include "Vboard.h"

namespace sim::board {

struct Motors {
  std::uint64_t step;
  std::uint64_t direction;
  std::uint64_t enabled;
};

inline constexpr unsigned all_motors = (1U << axis_count) - 1;

// Of a board whose pins are low where a driver is enabled.
template <typename Model>
Motors motors_enabled_low(const Model& model) {
  return {model.step, model.direction, ~model.motor_enable_n & all_motors};
}

}  // namespace sim::board
