// SPDX-License-Identifier: Apache-2.0
// [probe] and [mesh] of a machine description.
#pragma once

#include <optional>
#include <string>

#include "application/machine_description.hpp"
#include "machine_generator/reader.hpp"

namespace machine_generator {

// Both tables or neither. After the axes and the kinematics, which bound where the probe can go.
std::optional<motion::LevellingSettings> read_levelling(
    Reader& root, const application::MachineDescription& machine);

// The constant in the header, to which the description points.
std::string levelling_text(const motion::LevellingSettings& settings);

}  // namespace machine_generator
