// SPDX-License-Identifier: Apache-2.0
// On hosts all parts are in the program, and each machine description says what it has.
#include "application/levelling_commands.hpp"
#include "application/machine_description.hpp"
#include "application/setting_reports.hpp"

namespace application {

const bool shaping_in_image = true;
const bool levelling_in_image = true;
const bool filament_in_image = true;
const bool automatic_retraction_in_image = true;

Progress LevellingCommands::execute(ActiveCommand& command) {
  return motion_.levels() ? execute_fitted(command) : command.report_not_fitted();
}

}  // namespace application
