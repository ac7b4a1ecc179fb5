// SPDX-License-Identifier: Apache-2.0
// Why a line is not a command, and the position of the error.
#pragma once

#include <cstdint>
#include <string_view>

namespace gcode {

enum class ParseFault : std::uint8_t {
  empty_line,  // nothing, or a comment only: no mistake, and nothing to do
  unknown_letter,  // the first word is not G, M or T
  missing_code,  // G without a number
  code_overflow,  // G70000: codes go to 65535
  malformed_code,  // G1. or G38.x, subcodes go to 255
  unexpected_character,  // where a parameter letter should stand
  malformed_number,  // X1.2.3, X--1, X.
  number_overflow,  // beyond +-4294967295.999999
  duplicate_letter,  // X1 X2
  second_command,  // G90 G1: one line holds one command
  unprintable_byte,  // a control character or a byte beyond 0x7e outside of text and comments
  unclosed_comment,  // ( without )
  unclosed_quote,  // P"MK3S
};

struct ParseError {
  ParseFault fault;
  std::uint32_t position;  // of the byte where the fault shows, from 0

  bool operator==(const ParseError&) const = default;
};

// A phrase for the host's console, such as "malformed number".
std::string_view describe(ParseFault fault);
inline std::string_view describe(ParseError error) { return describe(error.fault); }

}  // namespace gcode
