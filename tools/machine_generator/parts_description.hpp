// SPDX-License-Identifier: Apache-2.0
// [backlash], [filament_sensor] and [filament_change] of a machine description.
#pragma once

#include <optional>
#include <string>

#include "application/machine_description.hpp"
#include "machine_generator/reader.hpp"

namespace machine_generator {

// What the description points to.
struct Parts {
  std::optional<motion::BacklashSettings> backlash{};
  std::optional<application::FilamentSensor> filament_sensor{};
  std::optional<application::FilamentChange> filament_change{};
};

// After axes, kinematics and probe, with which they must agree.
Parts read_parts(Reader& root, const application::MachineDescription& machine,
                 const std::optional<motion::LevellingSettings>& levelling);

// The constants in the header, and the description's entries for them.
std::string parts_text(const Parts& parts);
std::string parts_entries(const Parts& parts);

}  // namespace machine_generator
