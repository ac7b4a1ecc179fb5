// SPDX-License-Identifier: Apache-2.0
// Chosen in an image for machines with kinematics = "cartesian".
#pragma once

#include "motion/kinematics/cartesian.hpp"

namespace motion::kinematics {

using Chosen = Cartesian;

}  // namespace motion::kinematics
