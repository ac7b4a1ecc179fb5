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
constexpr unsigned most_zeros = 6;  // that are written for places without a digit

constexpr std::uint64_t power_of_ten(unsigned exponent) {
  std::uint64_t power = 1;
  units::LoopBound<longest_number> factors;
  while (exponent-- > 0) {
    factors.next();
    power *= 10;
  }
  return power;
}

}  // namespace

TextLine& TextLine::text(std::string_view part) {
  if (!complete_) return *this;
  units::LoopBound<capacity + 1> characters;  // the last of them finds no room
  for (std::size_t i = 0; i < part.size(); ++i) {
    characters.next();
    if (length_ == capacity) {
      complete_ = false;
      break;
    }
    buffer_[length_++] = part[i];
    units::happens<units::Event::character_written>(length_);
  }
  return *this;
}

TextLine& TextLine::character(char c) {
  if (length_ == capacity) complete_ = false;
  if (complete_) buffer_[length_++] = c;
  return *this;
}

TextLine& TextLine::integer(std::int64_t value) {
  if (value < 0) character('-');
  return digits(units::magnitude(value), 1);
}

TextLine& TextLine::decimal(std::int64_t value, unsigned digit_count, unsigned places) {
  const std::uint64_t divisor = power_of_ten(digit_count - places);
  const std::uint64_t rounded = (units::magnitude(value) + divisor / 2) / divisor;
  if (value < 0 && rounded != 0) character('-');
  const std::uint64_t unit = power_of_ten(places);
  digits(rounded / unit, 1);
  if (places == 0) return *this;
  return character('.').digits(rounded % unit, places);
}

TextLine& TextLine::digits(std::uint64_t value, unsigned at_least) {
  std::array<char, longest_number> reversed;
  unsigned count = 0;
  // 64-bit division is a library call of a thousand clocks on the soft core: only where it
  // is needed.
  units::LoopBound<longest_number / 2> upper_digits;
  while (value > UINT32_MAX) {
    upper_digits.next();
    reversed[count++] = static_cast<char>('0' + value % 10);
    value /= 10;
    units::happens<units::Event::long_digit>();
  }
  units::LoopBound<longest_number / 2, 1> lower_digits;
  for (auto rest = static_cast<std::uint32_t>(value); rest != 0; rest /= 10) {
    lower_digits.next();
    reversed[count++] = static_cast<char>('0' + rest % 10);
  }
  units::LoopBound<most_zeros> zeros;
  while (count < at_least) {
    zeros.next();
    reversed[count++] = '0';
  }
  units::LoopBound<longest_number, 1> characters;
  while (count > 0) {
    characters.next();
    character(reversed[--count]);
  }
  return *this;
}

void TextLine::clear() {
  length_ = 0;
  complete_ = true;
}

}  // namespace host_link
