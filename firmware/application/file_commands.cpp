// SPDX-License-Identifier: Apache-2.0
// Refusals of commands that need a card.
#include "application/file_commands.hpp"

namespace application {
namespace {

Progress refuse_without_card(ActiveCommand& command) { return command.refuse("No SD card"); }

}  // namespace

Progress FileCommands::select(ActiveCommand& command) {
  file_refused_ = true;
  return refuse_without_card(command);
}

// Of a file of the host's it asks the host to go on.
Progress FileCommands::resume(ActiveCommand& command) {
  if (!file_refused_) {
    return command.say("//action:resume");
  }
  if (refuse_without_card(command) == Progress::again) return Progress::again;
  file_refused_ = false;
  return Progress::done;
}

Progress FileCommands::begin_storing(ActiveCommand& command) {
  storing_ = true;
  return refuse_to_store(command);
}

Progress FileCommands::end_storing(ActiveCommand& command) {
  storing_ = false;
  return refuse_without_card(command);
}

Progress FileCommands::refuse_to_store(ActiveCommand& command) {
  return command.refuse("No SD card until M29");
}

}  // namespace application
