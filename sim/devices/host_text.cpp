// SPDX-License-Identifier: Apache-2.0
// Letters of either case, as Marlin's hosts take them.
#include "sim/devices/host_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>

namespace devices {

std::string lower_case(std::string_view text) {
  std::string result(text);
  std::ranges::transform(result, result.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

bool contains_any(const std::string& text, std::initializer_list<std::string_view> words) {
  return std::ranges::any_of(words, [&](std::string_view word) { return text.contains(word); });
}

std::optional<std::size_t> first_number(std::string_view text) {
  const std::size_t begin = text.find_first_of("0123456789");
  if (begin == std::string_view::npos) return std::nullopt;
  std::size_t number = 0;
  const auto result = std::from_chars(text.data() + begin, text.data() + text.size(), number);
  return result.ec == std::errc{} ? std::optional(number) : std::nullopt;
}

std::string numbered_line(std::size_t number, std::string_view command) {
  std::string line = fmt::format("N{} {}", number, command);
  unsigned checksum = 0;
  for (const char character : line) checksum ^= static_cast<std::uint8_t>(character);
  return line + fmt::format("*{}\n", checksum);
}

bool is_command(std::string_view text, std::string_view name) {
  if (lower_case(text.substr(0, 1)) != lower_case(name.substr(0, 1))) return false;
  const std::size_t digits = text.find_first_not_of(" \t", 1);
  if (digits == std::string_view::npos) return false;
  unsigned code = 0, wanted = 0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data() + digits, end, code);
  std::from_chars(name.data() + 1, name.data() + name.size(), wanted);
  return read.ec == std::errc{} && code == wanted && (read.ptr == end || *read.ptr != '.');
}

bool waits_for_a_time(std::string_view text) {
  std::size_t at = text.find_first_of("01");
  while (at != std::string_view::npos) {
    at = text.find_first_not_of(' ', at + 1);
    const std::size_t digits =
        at == std::string_view::npos ? at : text.find_first_not_of(' ', at + 1);
    double number = 0;
    if (digits == std::string_view::npos ||
        std::from_chars(text.data() + digits, text.data() + text.size(), number).ec !=
            std::errc{}) {
      return false;
    }
    const char letter = static_cast<char>(std::toupper(static_cast<unsigned char>(text[at])));
    if ((letter == 'S' || letter == 'P') && number > 0) return true;
    at = text.find_first_not_of("+-.0123456789", digits);
    at = at == std::string_view::npos ? at : at - 1;
  }
  return false;
}

std::string shortened(const std::string& text) {
  constexpr std::size_t longest = 60;
  return text.size() <= longest ? text : text.substr(0, longest) + "...";
}

std::string place_of(const FileCommand& command) {
  if (command.file_line == 0) return fmt::format("the host's \"{}\"", command.text);
  return fmt::format("line {} \"{}\"", command.file_line, shortened(command.text));
}

}  // namespace devices
