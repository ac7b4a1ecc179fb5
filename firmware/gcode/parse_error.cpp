// SPDX-License-Identifier: Apache-2.0
// The phrases in which parse errors are reported to the host.
#include "gcode/parse_error.hpp"

namespace gcode {

std::string_view describe(ParseFault fault) {
  switch (fault) {
    case ParseFault::empty_line:
      return "empty line";
    case ParseFault::unknown_letter:
      return "no G, M or T at its start";
    case ParseFault::missing_code:
      return "no number after the command letter";
    case ParseFault::code_overflow:
      return "command number above 65535";
    case ParseFault::malformed_code:
      return "malformed command number";
    case ParseFault::unexpected_character:
      return "unexpected character";
    case ParseFault::malformed_number:
      return "malformed number";
    case ParseFault::number_overflow:
      return "number beyond 4294967295";
    case ParseFault::duplicate_letter:
      return "parameter given twice";
    case ParseFault::second_command:
      return "second command in one line";
    case ParseFault::unprintable_byte:
      return "unprintable byte";
    case ParseFault::unclosed_comment:
      return "comment without closing parenthesis";
    case ParseFault::unclosed_quote:
      return "text without closing quote";
  }
  return "unknown fault";
}

}  // namespace gcode
