// SPDX-License-Identifier: Apache-2.0
// G92: the new coordinates of the present position.
#include "application/coordinate_commands.hpp"

namespace application {

Progress CoordinateCommands::set_position(ActiveCommand& command) {
  Positions positions = coordinates_.logical();
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    const auto value = coordinates_.length(command.command, units::axis_letters[i]);
    if (value) positions[i] = *value;
  }
  if (!representable(positions)) return command.refuse("Number out of range");
  coordinates_.set_logical(positions);
  return Progress::done;
}

}  // namespace application
