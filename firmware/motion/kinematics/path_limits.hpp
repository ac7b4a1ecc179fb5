// SPDX-License-Identifier: Apache-2.0
// What axes and motors allow where an axis is not its motor.
#pragma once

#include "motion/kinematics/kinematics.hpp"
#include "motion/line.hpp"

namespace motion::kinematics {

// The path's speed at which none of X, Y and Z is faster than its maximum.
units::MicrometersPerSecond speed_of_axes(const Limits& limits, const Place& from, const Place& to);

// Lowers the acceleration of a line so far that no motor of X, Y and Z exceeds its maximum, by the
// mean of its speed along the line.
void limit_to_motors(const Limits& limits, const Displacement& displacement, Line& line,
                     Course& course);

}  // namespace motion::kinematics
