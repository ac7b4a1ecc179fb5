// SPDX-License-Identifier: Apache-2.0
// Chosen in an image for machines with kinematics = "delta".
#pragma once

#include "motion/kinematics/delta.hpp"

namespace motion::kinematics {

using Chosen = Delta;

}  // namespace motion::kinematics
