// SPDX-License-Identifier: Apache-2.0
// Numbers to text for the reply lines.
#include "host_link/text_line.hpp"

#include <algorithm>

#include "units/event_bound.hpp"
#include "units/loop_bound.hpp"
#include "units/magnitude.hpp"

namespace host_link {
namespace {

constexpr unsigned longest_number = 20;  // digits of 2^64
constexpr unsigned word_digits = 10;  // of 2^32

constexpr std::array<std::uint32_t, 7> powers_of_ten{1, 10, 100, 1'000, 10'000, 100'000, 1'000'000};

// Divisions take the processor 18 clocks, multiplications one.
constexpr std::uint32_t tenth(std::uint32_t value) {
  constexpr std::uint64_t reciprocal = 0xCCCC'CCCD;  // of 10, with 35 fractional bits
  return static_cast<std::uint32_t>(value * reciprocal >> 35);
}
static_assert(tenth(UINT32_MAX) == UINT32_MAX / 10 && tenth(9) == 0 && tenth(10) == 1);

constexpr std::uint32_t long_part = 1'000'000'000;
constexpr int long_part_digits = 9;

// At least so many, from the last one on, before what begins there; returns where they begin.
[[gnu::noinline]] char* put_digits(char* begin, const char* point, std::uint32_t value, int least) {
  units::LoopBound<word_digits> digits;
  do {
    digits.next();
    const std::uint32_t rest = tenth(value);
    units::happens<units::Event::digit_written>(rest);
    *--begin = static_cast<char>('0' + (value - rest * 10));
    value = rest;
    if (begin == point) *--begin = '.';
    --least;
    // In one condition, since the bound of a loop belongs to one way back.
  } while (static_cast<int>(least > 0) + static_cast<int>(value != 0) != 0);
  return begin;
}

}  // namespace

TextLine& TextLine::text(std::string_view part) {
  const std::size_t room = complete_ ? capacity - length_ : 0;
  if (part.size() > room) complete_ = false;
  const char* from = part.data();
  const char* const end = from + std::min(part.size(), room);
  char* to = buffer_.data() + length_;
  units::LoopBound<capacity> characters;
  if (from != end) {
    do {
      characters.next();
      *to++ = *from++;
      units::happens<units::Event::character_written>(reinterpret_cast<std::uintptr_t>(from));
    } while (from != end);
  }
  length_ = static_cast<std::size_t>(to - buffer_.data());
  return *this;
}

TextLine& TextLine::character(char c) { return text({&c, 1}); }

TextLine& TextLine::integer(std::int64_t value) {
  if (value < 0) character('-');
  return digits(units::magnitude(value), 0);
}

TextLine& TextLine::decimal(std::int64_t value, unsigned digit_count, unsigned places) {
  const std::uint32_t divisor = powers_of_ten[digit_count - places];
  const std::uint64_t rounded = (units::magnitude(value) + divisor / 2) / divisor;
  if (value < 0 && rounded != 0) character('-');
  return digits(rounded, places);
}

// So many of the digits behind a point, and at least one before it. From the last one on, nine at a
// time where 32 bits do not hold them all: a division of 64 bits takes hundreds of clocks.
TextLine& TextLine::digits(std::uint64_t value, unsigned places) {
  std::array<char, longest_number + 1> characters;
  char* const end = characters.data() + characters.size();
  const char* const point = end - places;
  char* begin = end;
  units::LoopBound<longest_number / long_part_digits> parts;
  while (value > UINT32_MAX) {
    parts.next();
    units::happens<units::Event::long_digit>(static_cast<std::size_t>(value));
    const std::uint64_t rest = value / long_part;
    begin = put_digits(begin, point, static_cast<std::uint32_t>(value - rest * long_part),
                       long_part_digits);
    value = rest;
  }
  begin = put_digits(begin, point, static_cast<std::uint32_t>(value),
                     static_cast<int>(places) + 1 - static_cast<int>(end - begin));
  return text({begin, end});
}

void TextLine::clear() {
  length_ = 0;
  complete_ = true;
}

}  // namespace host_link
