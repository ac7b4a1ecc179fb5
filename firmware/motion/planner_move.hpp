// SPDX-License-Identifier: Apache-2.0
// What the planner is asked for.
#pragma once

#include <cstdint>

#include "units/axes.hpp"
#include "units/position.hpp"
#include "units/quantity.hpp"

namespace motion {

// A straight move to `target`, in absolute machine coordinates.
struct LineMove {
  units::PerAxis<units::Position> target{};
  // Along X, Y and Z; of E alone where they stand still. 1 .. max_speed; what an axis cannot do
  // is slower.
  units::MicrometersPerSecond feedrate{};
  std::uint8_t stop_mask{};  // end stops (bit = input) that end all motion
  bool of_motors{};  // `target` is the motors', where homing moves these (kinematics)
};

}  // namespace motion
