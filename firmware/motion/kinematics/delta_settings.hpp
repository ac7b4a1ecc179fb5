// SPDX-License-Identifier: Apache-2.0
// The geometry of a delta as M665 and M666 may make it.
#pragma once

#include <string_view>

#include "motion/kinematics/delta.hpp"

namespace motion::kinematics {

// Sets the towers from the radius and the trims of their angles.
void place_towers(Delta::Parameters& delta);

// Why such a machine could not be moved exactly; empty where it can. Rods have 18 degrees at least
// above the horizontal, as of the machine description, and 72 at most where the tool is in the
// middle: beyond it the tool would leave its line by more than the carriages do.
std::string_view fault_of(const Delta::Parameters& delta);

}  // namespace motion::kinematics
