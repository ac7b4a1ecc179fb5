// SPDX-License-Identifier: Apache-2.0
// The part of the table of commands that is in the image: without help and units.
#pragma once

#include "application/gcode_row.hpp"

namespace application {

struct GcodeEntry {
  char letter;
  Start start;
  bool refuses_others;
  bool while_storing;
  bool while_dry_run;
  std::uint16_t code;
  std::uint8_t first_limit;  // of all limits
  std::uint8_t limit_count;
  std::uint32_t letters;  // of its arguments, as gcode::Command has them
  Handler handler;
  Handler report;

  // There is no second T command: its code is the number of the tool.
  bool is_of(const gcode::Command& command) const {
    return command.letter == letter && (command.code == code || letter == 'T');
  }
  ArgumentLimits limits() const;
};

// Null where there is none. Subcodes are not looked at.
const GcodeEntry* find_entry(const gcode::Command& command);

}  // namespace application
