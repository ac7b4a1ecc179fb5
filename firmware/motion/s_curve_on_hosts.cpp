// SPDX-License-Identifier: Apache-2.0
// On hosts ramps of third order are in the program, and each machine description says whether it
// has them.
#include "motion/s_curve.hpp"

namespace motion {

const bool s_curve_in_image = true;

}  // namespace motion
