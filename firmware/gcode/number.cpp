// SPDX-License-Identifier: Apache-2.0
// The decimal number reader: 32-bit arithmetic, no division.
#include "gcode/number.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
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
  if (value >= largest / 10 && (value > largest / 10 || digit > largest % 10)) return false;
  value = value * 10 + digit;
  return true;
}

std::uint32_t digit_value(char c) { return static_cast<std::uint32_t>(c - '0'); }

std::unexpected<ParseError> fail(ParseFault fault, std::size_t position) {
  return std::unexpected(ParseError{fault, static_cast<std::uint32_t>(position)});
}

// Reads the digits after the point. False if rounding reaches a whole unit.
bool read_fraction(const char*& here, const char* end, std::uint32_t& billionths) {
  const char* const first = here;
  std::uint32_t value = 0;
  units::LoopBound<kept_decimals> kept;
  while (here != end && is_digit(*here) && here - first < std::ptrdiff_t{kept_decimals}) {
    kept.next();
    value = value * 10 + digit_value(*here++);
  }
  value *= scale[static_cast<std::size_t>(here - first)];
  // Decimals that are not kept: the first one alone decides the rounding.
  if (here != end && is_digit(*here)) {
    if (*here >= '5') ++value;
    units::LoopBound<units::longest_text> dropped;
    while (here != end && is_digit(*here)) {
      dropped.next();
      ++here;
      units::happens<units::Event::character_read>(reinterpret_cast<std::uintptr_t>(here));
    }
  }
  const bool is_fraction = value < billionths_per_unit;
  billionths = is_fraction ? value : 0;
  return is_fraction;
}

}  // namespace

std::expected<Number, ParseError> read_number(std::string_view line, std::size_t& position) {
  const char* const begin = line.data();
  const char* const end = begin + line.size();
  const char* here = begin + position;
  const auto fail_at = [begin](ParseFault fault, const char* place) {
    return fail(fault, static_cast<std::size_t>(place - begin));
  };
  const char* const start = here;
  Number number{};
  if (here != end && (*here == '-' || *here == '+')) number.negative = *here++ == '-';
  const char* const first_digit = here;
  std::uint32_t whole = 0;
  units::LoopBound<units::longest_text> whole_digits;
  while (here != end && is_digit(*here)) {
    whole_digits.next();
    if (!append(whole, digit_value(*here))) return fail_at(ParseFault::number_overflow, start);
    ++here;
    units::happens<units::Event::character_read>(reinterpret_cast<std::uintptr_t>(here));
  }
  std::ptrdiff_t digits = here - first_digit;
  if (here != end && *here == '.') {
    const char* const point = here++;
    if (!read_fraction(here, end, number.billionths)) {
      if (whole == std::numeric_limits<std::uint32_t>::max()) {
        return fail_at(ParseFault::number_overflow, start);
      }
      ++whole;
    }
    digits += here - point - 1;
  }
  if (digits == 0) return fail_at(ParseFault::malformed_number, start);
  if (here != end && starts_number(*here)) return fail_at(ParseFault::malformed_number, here);
  number.whole = whole;
  position = static_cast<std::size_t>(here - begin);
  return number;
}

}  // namespace gcode
