// SPDX-License-Identifier: Apache-2.0
// Checks that a file is text and strips what a host program does not send.
#include "sim/devices/gcode_file.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <fstream>
#include <iterator>
#include <optional>

namespace devices {

namespace {

// The number of bytes of the UTF-8 character at the beginning of `text`, or nothing where it is
// none.
std::optional<std::size_t> character_length(std::string_view text) {
  const auto first = static_cast<std::uint8_t>(text.front());
  std::size_t length = 1;
  if (first >= 0xf5 || (first >= 0x80 && first < 0xc2)) {
    return std::nullopt;
  }
  if (first >= 0xf0) {
    length = 4;
  } else if (first >= 0xe0) {
    length = 3;
  } else if (first >= 0xc2) {
    length = 2;
  }
  if (text.size() < length) {
    return std::nullopt;
  }
  for (std::size_t i = 1; i < length; ++i) {
    if ((static_cast<std::uint8_t>(text[i]) & 0xc0) != 0x80) {
      return std::nullopt;
    }
  }
  return length;
}

bool is_control_character(char character) {
  const auto code = static_cast<std::uint8_t>(character);
  return (code < 0x20 && character != '\t' && character != '\r' && character != '\n') ||
         code == 0x7f;
}

// The printable ASCII text of a line of the file, or nothing where the line is not text.
std::optional<std::string> printable(std::string_view line) {
  std::string text;
  while (!line.empty()) {
    const std::optional<std::size_t> length = character_length(line);
    if (!length || is_control_character(line.front())) {
      return std::nullopt;
    }
    const bool blank = line.front() == '\t' || line.front() == '\r';
    text += *length > 1 ? '?' : blank ? ' ' : line.front();
    line.remove_prefix(*length);
  }
  return text;
}

std::string without_comment(const std::string& line) {
  std::string command;
  bool in_parentheses = false;
  for (const char character : line) {
    if (character == ';') {
      break;
    }
    if (character == '(') {
      in_parentheses = true;
    } else if (character == ')' && in_parentheses) {
      in_parentheses = false;
    } else if (!in_parentheses) {
      command += character;
    }
  }
  const std::size_t first = command.find_first_not_of(' ');
  if (first == std::string::npos) {
    return {};
  }
  return command.substr(first, command.find_last_not_of(' ') - first + 1);
}

}  // namespace

std::expected<std::vector<FileCommand>, std::string> parse_gcode_text(std::string_view text,
                                                                      std::string_view name) {
  std::vector<FileCommand> commands;
  std::size_t file_line = 0;
  while (!text.empty()) {
    ++file_line;
    const std::size_t end = text.find('\n');
    const std::optional<std::string> line = printable(text.substr(0, end));
    if (!line) {
      return std::unexpected(fmt::format(
          "{} is not a G-code file: line {} holds bytes that are no text", name, file_line));
    }
    std::string command = without_comment(*line);
    if (!command.empty()) {
      commands.push_back({file_line, std::move(command)});
    }
    text = end == std::string_view::npos ? std::string_view{} : text.substr(end + 1);
  }
  if (commands.empty()) {
    return std::unexpected(fmt::format("{} holds no G-code command", name));
  }
  return commands;
}

std::expected<std::vector<FileCommand>, std::string> read_gcode_file(
    const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) {
    return std::unexpected(fmt::format("{} does not exist", file.string()));
  }
  if (!std::filesystem::is_regular_file(file, error)) {
    return std::unexpected(fmt::format("{} is not a file", file.string()));
  }
  std::ifstream stream(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream) {
    return std::unexpected(fmt::format("{} cannot be read", file.string()));
  }
  return parse_gcode_text(text, file.string());
}

}  // namespace devices
