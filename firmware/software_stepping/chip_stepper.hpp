// SPDX-License-Identifier: Apache-2.0
// The one stepper of the chip, which its interrupt must find.
#pragma once

#include "software_stepping/stepper.hpp"

namespace software_stepping {

// Defined once per world, as the bus.
Stepper& chip_stepper();

}  // namespace software_stepping
