// SPDX-License-Identifier: Apache-2.0
// The stepper of the chip, for its interrupt.
#pragma once

#include "software_stepping/stepper.hpp"

namespace software_stepping {

// Defined once per program, as the bus.
Stepper& chip_stepper();

}  // namespace software_stepping
