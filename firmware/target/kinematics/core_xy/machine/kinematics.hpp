// SPDX-License-Identifier: Apache-2.0
// Chosen in an image for machines with kinematics = "core_xy".
#pragma once

#include "motion/kinematics/core_xy.hpp"

namespace motion::kinematics {

using Chosen = CoreXy;

}  // namespace motion::kinematics
