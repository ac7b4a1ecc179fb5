// SPDX-License-Identifier: Apache-2.0
// The arms of a SCARA in a machine description.
#pragma once

#include "application/machine_description.hpp"
#include "machine_generator/reader.hpp"

namespace machine_generator {

// Reads the table `scara`, after the axes: checks that the arms neither stretch nor fold on the
// bed, and that the travel of their motors suffices for it.
void read_scara(Reader& root, application::MachineDescription& machine);

}  // namespace machine_generator
