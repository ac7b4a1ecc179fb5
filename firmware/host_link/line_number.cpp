// SPDX-License-Identifier: Apache-2.0
// Reads the line numbers in framing and in M110.
#include "host_link/line_number.hpp"

#include <limits>

#include "host_link/emergency.hpp"
#include "host_link/line_receiver.hpp"
#include "units/digits.hpp"
#include "units/loop_bound.hpp"
#include "units/text.hpp"

namespace host_link {

using units::is_digit;

std::optional<LineNumber> take_line_number(std::string_view& text) {
  std::size_t position = 0;
  const bool negative = !text.empty() && text.front() == '-';
  if (negative) ++position;
  if (position >= text.size() || !is_digit(text[position])) return std::nullopt;
  const std::uint32_t limit = negative ? 1u << 31 : std::numeric_limits<std::uint32_t>::max();
  std::uint32_t magnitude = 0;
  units::LoopBound<max_line_length> digits;
  for (; position < text.size() && is_digit(text[position]); ++position) {
    digits.next();
    const auto digit = static_cast<std::uint32_t>(text[position] - '0');
    const std::uint64_t longer = std::uint64_t{magnitude} * 10 + digit;
    if (longer > limit) return std::nullopt;
    magnitude = static_cast<std::uint32_t>(longer);
  }
  text.remove_prefix(position);
  return negative ? 0 - magnitude : magnitude;
}

bool looks_like_command(std::string_view text) {
  constexpr std::string_view letters = "GMTgmt";
  return text.size() >= 2 && units::find(letters, text[0]) != std::string_view::npos &&
         is_digit(text[1]);
}

bool sets_numbering(std::string_view text) {
  constexpr std::uint32_t code = 110;
  return take_m_code(text) == code;
}

std::optional<LineNumber> number_set_by(std::string_view text) {
  const std::size_t letter = units::find_first_of(text, "Nn");
  if (letter == std::string_view::npos) return std::nullopt;
  text.remove_prefix(letter + 1);
  return take_line_number(text);
}

}  // namespace host_link
