// SPDX-License-Identifier: Apache-2.0
// Reads the line numbers in framing and in M110.
#include "host_link/line_number.hpp"

#include <limits>

#include "host_link/emergency.hpp"
#include "host_link/line_receiver.hpp"
#include "units/digits.hpp"
#include "units/event_bound.hpp"
#include "units/loop_bound.hpp"
#include "units/text.hpp"

namespace host_link {

using units::is_digit;

std::optional<LineNumber> take_line_number(std::string_view& text) {
  std::size_t position = 0;
  const bool negative = !text.empty() && text.front() == '-';
  if (negative) ++position;
  if (position >= text.size() || !is_digit(text[position])) return std::nullopt;
  constexpr std::uint32_t largest = std::numeric_limits<std::uint32_t>::max();
  const std::uint32_t most_tenths = negative ? (1u << 31) / 10 : largest / 10;
  const std::uint32_t last_digit = negative ? (1u << 31) % 10 : largest % 10;
  std::uint32_t magnitude = 0;
  units::LoopBound<max_line_length> digits;
  for (; position < text.size() && is_digit(text[position]); ++position) {
    digits.next();
    const auto digit = static_cast<std::uint32_t>(text[position] - '0');
    if (magnitude >= most_tenths && (magnitude > most_tenths || digit > last_digit)) {
      return std::nullopt;
    }
    magnitude = magnitude * 10 + digit;
    units::happens<units::Event::character_read>(magnitude);
  }
  text.remove_prefix(position);
  return negative ? 0 - magnitude : magnitude;
}

std::uint32_t fingerprint_of(std::string_view text) {
  std::uint32_t hash = 2'166'136'261;
  units::LoopBound<max_line_length> bound;
  for (const char c : text) {
    bound.next();
    hash = (hash ^ static_cast<unsigned char>(c)) * 16'777'619;
  }
  return hash;
}

bool looks_like_command(std::string_view text) {
  constexpr std::string_view letters = "GMTgmt";
  return text.size() >= 2 && units::find(letters, text[0]) != std::string_view::npos &&
         is_digit(text[1]);
}

bool sets_numbering(std::string_view text) { return take_m_code(text) == numbering_code; }

std::optional<LineNumber> number_set_by(std::string_view arguments) {
  units::EventBound<units::Event::character_read, max_line_length - shortest_command> read;
  if (!skip_behind_letter(arguments, 'N')) return std::nullopt;
  return take_line_number(arguments);
}

}  // namespace host_link
