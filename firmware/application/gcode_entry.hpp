// SPDX-License-Identifier: Apache-2.0
// The part of the table of commands that is in the image: without help and units, and with what
// rows have in common only once.
#pragma once

#include "application/gcode_row.hpp"

namespace application {

struct GcodeEntry {
  std::uint16_t key;  // letter and code, in the order of the table
  Start start : 2;
  bool refuses_others : 1;
  bool while_storing : 1;
  bool while_dry_run : 1;
  std::uint8_t most_subcode : 3;
  // Indices: of all sets of arguments, all handlers, all reports.
  std::uint8_t argument_set;
  std::uint8_t handler_index;
  std::uint8_t report_index;

  // There is no second T command: its code is the number of the tool.
  bool is_of(const gcode::Command& command) const;
  // Of its arguments, as gcode::Command has them; none where nothing depends on them: others are
  // not refused, and no report stands for a line without them.
  std::uint32_t letters() const;
  ArgumentLimits limits() const;
  bool has_handler() const;
  Handler handler() const;
  Handler report() const;
};

// Null where there is none. Subcodes are not looked at.
const GcodeEntry* find_entry(const gcode::Command& command);

}  // namespace application
