// SPDX-License-Identifier: Apache-2.0
// On the host one program serves every machine. An image for the chip has the file of this name in
// firmware/target/kinematics instead.
#pragma once

#include "motion/kinematics/any.hpp"

namespace motion::kinematics {

using Chosen = Any;

}  // namespace motion::kinematics
