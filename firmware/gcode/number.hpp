// SPDX-License-Identifier: Apache-2.0
// Reads a decimal number as G-code writes it: -.5, X10., +3, 1.2345678.
#pragma once

#include <cstddef>
#include <expected>
#include <string_view>

#include "gcode/command.hpp"
#include "gcode/parse_error.hpp"
#include "units/digits.hpp"

namespace gcode {

using units::is_digit;

// Whether a number, well formed or not, starts with this character.
constexpr bool starts_number(char c) { return is_digit(c) || c == '.' || c == '-' || c == '+'; }

// Reads at `position` and moves it after the number. Beyond nine decimals it rounds half
// away from zero.
std::expected<Number, ParseError> read_number(std::string_view line, std::size_t& position);

}  // namespace gcode
