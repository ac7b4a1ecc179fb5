// SPDX-License-Identifier: Apache-2.0
// On hosts all parts are in the program, and each machine description says what it has.
#include "motion/backlash.hpp"
#include "motion/s_curve.hpp"

namespace motion {

const bool backlash_in_image = true;
const bool s_curve_in_image = true;

}  // namespace motion
