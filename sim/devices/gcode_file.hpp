// SPDX-License-Identifier: Apache-2.0
// Reads a G-code file as a host program does: commands without comments, with their line numbers.
#pragma once

#include <cstddef>
#include <expected>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace devices {

struct FileCommand {
  std::size_t file_line{};  // from 1
  std::string text;  // without comment and outer blanks, printable ASCII only
};

// Comments are `; ...` to the end of the line and `( ... )`. A line's own number and checksum are
// taken off, since the host numbers the lines itself. Characters beyond ASCII become `?`, since no
// firmware of the field reads them. The error is a sentence for the user: the file is missing,
// unreadable, binary (a NUL or another control character, or a command that is not UTF-8), holds a
// line whose own checksum is wrong, or no command.
std::expected<std::vector<FileCommand>, std::string> read_gcode_file(
    const std::filesystem::path& file);

std::expected<std::vector<FileCommand>, std::string> parse_gcode_text(std::string_view text,
                                                                      std::string_view name);

}  // namespace devices
