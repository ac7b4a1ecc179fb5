// SPDX-License-Identifier: Apache-2.0
// Chosen in an image for machines with kinematics = "scara".
#pragma once

#include "motion/kinematics/scara.hpp"

namespace motion::kinematics {

using Chosen = Scara;

}  // namespace motion::kinematics
