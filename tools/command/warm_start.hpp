// SPDX-License-Identifier: Apache-2.0
// Where the heaters of a printed file begin with --warm.
#pragma once

#include <vector>

#include "sim/devices/gcode_file.hpp"
#include "sim/machine/description.hpp"
#include "tools/command/printer_setup.hpp"

namespace command {

// A little below the first target of each that the firmware takes; a note on stderr for one before
// it that is refused for being too hot.
StartTemperatures near_first_targets(const std::vector<devices::FileCommand>& commands,
                                     const machine::Description& description);

}  // namespace command
