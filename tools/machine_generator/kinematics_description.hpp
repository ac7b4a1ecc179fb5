// SPDX-License-Identifier: Apache-2.0
// The kinematics of a machine description.
#pragma once

#include <string>
#include <string_view>

#include "application/machine_description.hpp"
#include "machine_generator/reader.hpp"

namespace machine_generator {

// Reads `kinematics` and its table, after the axes.
void read_kinematics(Reader& root, application::MachineDescription& machine);

// The initialiser `.kinematics` of the description in C++; nothing for a Cartesian machine.
std::string kinematics_text(const motion::kinematics::Any::Parameters& parameters);
// As the description has it, and as firmware/target names its images.
std::string_view kinematics_name(const motion::kinematics::Any::Parameters& parameters);

}  // namespace machine_generator
