// SPDX-License-Identifier: Apache-2.0
// Parses one line of G-code into a command, or an error with its position.
#pragma once

#include <expected>
#include <optional>
#include <string_view>

#include "gcode/command.hpp"
#include "gcode/parse_error.hpp"

namespace gcode {

// `line` comes without line number, checksum and line end, and has at most units::longest_text
// bytes. It must outlive the command's text.
std::expected<Command, ParseError> parse(std::string_view line);

// The same into `command`, without a copy; nothing where that holds the command then.
std::optional<ParseError> parse(std::string_view line, Command& command);

}  // namespace gcode
