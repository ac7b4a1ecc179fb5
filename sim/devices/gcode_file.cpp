// SPDX-License-Identifier: Apache-2.0
// Checks that a file is text and strips what a host program does not send.
#include "sim/devices/gcode_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <optional>

#include "sim/devices/digits.hpp"

namespace devices {

namespace {

// The number of bytes of the UTF-8 character at the beginning of `text`, or nothing where
// it is none.
std::optional<std::size_t> character_length(std::string_view text) {
  const auto first = static_cast<std::uint8_t>(text.front());
  std::size_t length = 1;
  if (first >= 0xf5 || (first >= 0x80 && first < 0xc2)) return std::nullopt;
  if (first >= 0xf0) {
    length = 4;
  } else if (first >= 0xe0) {
    length = 3;
  } else if (first >= 0xc2) {
    length = 2;
  }
  if (text.size() < length) return std::nullopt;
  for (std::size_t i = 1; i < length; ++i) {
    if ((static_cast<std::uint8_t>(text[i]) & 0xc0) != 0x80) return std::nullopt;
  }
  return length;
}

bool is_control_character(char character) {
  const auto code = static_cast<std::uint8_t>(character);
  return (code < 0x20 && character != '\t' && character != '\r' && character != '\n') ||
         code == 0x7f;
}

// Where `; ...` begins, which is not within parentheses.
std::size_t end_of_command(std::string_view line) {
  std::size_t at = line.find_first_of("(;");
  while (at != std::string_view::npos && line[at] == '(') {
    const std::size_t closed = line.find(')', at);
    at = line.find_first_of(closed == std::string_view::npos ? ";" : "(;",
                            closed == std::string_view::npos ? at : closed);
  }
  return at;
}

// The printable ASCII text of a line of the file, or nothing where the line is not text. Of a
// comment only control characters count: it may be written in any encoding.
std::optional<std::string> printable(std::string_view line) {
  const std::size_t comment = std::min(end_of_command(line), line.size());
  if (std::ranges::any_of(line.substr(comment), is_control_character)) return std::nullopt;
  line = line.substr(0, comment);
  std::string text;
  while (!line.empty()) {
    const std::optional<std::size_t> length = character_length(line);
    if (!length || is_control_character(line.front())) return std::nullopt;
    const bool blank = line.front() == '\t' || line.front() == '\r';
    text += *length > 1 ? '?' : blank ? ' ' : line.front();
    line.remove_prefix(*length);
  }
  return text;
}

// Whose text may hold a star: M117 5*3
bool is_message(std::string_view text) {
  if (!text.starts_with('M') && !text.starts_with('m')) return false;
  const std::string_view code = text.substr(1, text.find_first_not_of("0123456789", 1) - 1);
  return code == "0" || code == "1" || code == "117" || code == "118";
}

// A line as it goes over a serial line: N5 G1 X1*76. Takes number and checksum off; says why not.
std::expected<std::string_view, std::string> without_frame(std::string_view line) {
  constexpr std::string_view blanks = " \t\r";
  line = line.substr(0, end_of_command(line));
  line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
  line = line.substr(0, line.find_last_not_of(blanks) + 1);
  const bool minus = line.size() > 1 && line[1] == '-';
  const bool numbered = (line.starts_with('N') || line.starts_with('n')) &&
                        line.size() > (minus ? 2U : 1U) && is_digit(line[minus ? 2 : 1]);
  std::string_view command = line;
  const std::size_t star = is_message(line) ? std::string_view::npos : line.rfind('*');
  if (star != std::string_view::npos) {
    const std::string_view behind = line.substr(star + 1);
    unsigned given = 0, right = 0;
    const auto end = std::from_chars(behind.data(), behind.data() + behind.size(), given);
    const bool checksum = end.ec == std::errc{} && end.ptr == behind.data() + behind.size();
    if (!checksum && numbered) {
      return std::unexpected(fmt::format("what follows its star is no checksum: \"*{}\"", behind));
    }
    if (!checksum) return line;
    command = line.substr(0, star);
    for (const char character : command) right ^= static_cast<std::uint8_t>(character);
    if (given != right) {
      return std::unexpected(
          fmt::format("its checksum is {}, but that of its text is {}", given, right));
    }
  }
  if (numbered) {
    const std::size_t end = command.find_first_not_of("0123456789", minus ? 2 : 1);
    command = end == std::string_view::npos ? std::string_view{} : command.substr(end);
  }
  return command;
}

std::string without_comment(std::string_view line) {
  line = line.substr(0, end_of_command(line));
  std::string command;
  while (!line.empty()) {
    const std::size_t open = line.find('(');
    const std::size_t closed =
        open == std::string_view::npos ? std::string_view::npos : line.find(')', open);
    // One that is not closed is sent as it is: the firmware refuses such a line.
    if (closed == std::string_view::npos) {
      command += line;
      break;
    }
    command += line.substr(0, open);
    line.remove_prefix(closed + 1);
  }
  const std::size_t first = command.find_first_not_of(' ');
  if (first == std::string::npos) return {};
  return command.substr(first, command.find_last_not_of(' ') - first + 1);
}

}  // namespace

std::expected<std::vector<FileCommand>, std::string> parse_gcode_text(std::string_view text,
                                                                      std::string_view name) {
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  std::vector<FileCommand> commands;
  std::size_t file_line = 0;
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  while (!text.empty()) {
    ++file_line;
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    if (!printable(line)) {
      return std::unexpected(fmt::format(
          "{} is not a G-code file: line {} holds bytes that are no text", name, file_line));
    }
    const auto plain = without_frame(line);
    if (!plain) {
      return std::unexpected(fmt::format("{}, line {}: {}", name, file_line, plain.error()));
    }
    std::string command = without_comment(*printable(*plain));
    if (!command.empty()) commands.push_back({file_line, std::move(command)});
    text = end == std::string_view::npos ? std::string_view{} : text.substr(end + 1);
  }
  if (commands.empty()) return std::unexpected(fmt::format("{} holds no G-code command", name));
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
  if (!stream) return std::unexpected(fmt::format("{} cannot be read", file.string()));
  return parse_gcode_text(text, file.string());
}

}  // namespace devices
