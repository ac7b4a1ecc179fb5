// SPDX-License-Identifier: Apache-2.0
// How fast the path may go round a corner between two lines, and from or to rest.
#pragma once

#include "motion/limits.hpp"
#include "motion/line.hpp"

namespace motion {

// Classic jerk, as Marlin's: no axis changes its speed by more than its jerk. With a junction
// deviation, where X, Y and Z lead both lines, E alone is limited so, and the path by two circles
// round which the acceleration is the lines' lower one: the one that touches both lines and passes
// the corner at that distance (S. Jeon, "Improving Grbl: Cornering Algorithm", 2011; Klipper,
// "Kinematics", junction speed), and the one that touches both in the middle of the shorter line,
// so that the short lines of a curve count as the curve.
SpecificEnergy junction_energy(const Course& before, const Course& after, const Limits& limits);

// The speed with which a line may begin from rest.
SpecificEnergy energy_from_rest(const Course& course, const Limits& limits);

}  // namespace motion
