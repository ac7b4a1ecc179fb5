// SPDX-License-Identifier: Apache-2.0
// On hosts all parts are in the program, and each machine description says what it has.
#include "application/machine_description.hpp"

namespace application {

const bool shaping_in_image = true;
const bool levelling_in_image = true;
const bool filament_in_image = true;

}  // namespace application
