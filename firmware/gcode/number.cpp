// SPDX-License-Identifier: Apache-2.0
// The decimal number reader: 32-bit arithmetic, no division.
#include "gcode/number.hpp"

#include <array>
#include <limits>

#include "units/event_bound.hpp"
#include "units/loop_bound.hpp"
#include "units/text.hpp"

namespace gcode {
namespace {

constexpr unsigned kept_decimals = 9;
// The factor from a fraction of this many digits to billionths.
constexpr std::array<std::uint32_t, kept_decimals + 1> scale{
    1'000'000'000, 100'000'000, 10'000'000, 1'000'000, 100'000, 10'000, 1'000, 100, 10, 1};
static_assert(scale[0] == billionths_per_unit && scale[kept_decimals] == 1);

// Appends a decimal digit; false on overflow.
bool append(std::uint32_t& value, std::uint32_t digit) {
  constexpr std::uint32_t largest = std::numeric_limits<std::uint32_t>::max();
  if (value > largest / 10 || (value == largest / 10 && digit > largest % 10)) return false;
  value = value * 10 + digit;
  return true;
}

std::uint32_t digit_value(char c) { return static_cast<std::uint32_t>(c - '0'); }

std::unexpected<ParseError> fail(ParseFault fault, std::size_t position) {
  return std::unexpected(ParseError{fault, static_cast<std::uint32_t>(position)});
}

// Reads the digits after the point. False if rounding reaches a whole unit.
bool read_fraction(std::string_view line, std::size_t& position, std::uint32_t& billionths) {
  unsigned decimals = 0;
  units::LoopBound<kept_decimals> kept;
  while (position < line.size() && is_digit(line[position]) && decimals < kept_decimals) {
    kept.next();
    billionths = billionths * 10 + digit_value(line[position++]);
    ++decimals;
  }
  billionths *= scale[decimals];
  // Decimals that are not kept: the first one alone decides the rounding.
  if (position < line.size() && is_digit(line[position])) {
    if (line[position] >= '5') ++billionths;
    units::LoopBound<units::longest_text> dropped;
    while (position < line.size() && is_digit(line[position])) {
      dropped.next();
      ++position;
      units::happens<units::Event::character_read>(position);
    }
  }
  if (billionths < billionths_per_unit) return true;
  billionths = 0;
  return false;
}

}  // namespace

std::expected<Number, ParseError> read_number(std::string_view line, std::size_t& position) {
  const std::size_t start = position;
  Number number{};
  if (position < line.size() && (line[position] == '-' || line[position] == '+')) {
    number.negative = line[position++] == '-';
  }
  const std::size_t first_digit = position;
  units::LoopBound<units::longest_text> whole_digits;
  while (position < line.size() && is_digit(line[position])) {
    whole_digits.next();
    if (!append(number.whole, digit_value(line[position]))) {
      return fail(ParseFault::number_overflow, start);
    }
    ++position;
    units::happens<units::Event::character_read>(position);
  }
  std::size_t digits = position - first_digit;
  if (position < line.size() && line[position] == '.') {
    const std::size_t point = position++;
    if (!read_fraction(line, position, number.billionths)) {
      if (number.whole == std::numeric_limits<std::uint32_t>::max()) {
        return fail(ParseFault::number_overflow, start);
      }
      ++number.whole;
    }
    digits += position - point - 1;
  }
  if (digits == 0) return fail(ParseFault::malformed_number, start);
  if (position < line.size() && starts_number(line[position])) {
    return fail(ParseFault::malformed_number, position);
  }
  return number;
}

}  // namespace gcode
