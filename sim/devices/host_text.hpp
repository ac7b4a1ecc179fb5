// SPDX-License-Identifier: Apache-2.0
// The texts of the dialogue between a host program and the chip: lines out, replies in.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include "sim/devices/gcode_file.hpp"

namespace devices {

std::string lower_case(std::string_view text);
bool contains_any(const std::string& text, std::initializer_list<std::string_view> words);
std::optional<std::size_t> first_number(std::string_view text);

// The line with its number, its checksum and its end.
std::string numbered_line(std::size_t number, std::string_view command);

// Whether a line is this command, also as "m 0110"; `name` is "M110".
bool is_command(std::string_view text, std::string_view name);
// M0 S5, M1 P500: until then, or until the user's answer. A message may follow the numbers.
bool waits_for_a_time(std::string_view text);

// For messages.
std::string shortened(const std::string& text);
std::string place_of(const FileCommand& command);

}  // namespace devices
