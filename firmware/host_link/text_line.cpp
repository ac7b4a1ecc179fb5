// SPDX-License-Identifier: Apache-2.0
// Numbers to text for the reply lines.
#include "host_link/text_line.hpp"

#include <algorithm>

#include "units/magnitude.hpp"

namespace host_link {
namespace {

constexpr unsigned longest_number = 20;  // digits of 2^64

constexpr std::uint64_t power_of_ten(unsigned exponent) {
  std::uint64_t power = 1;
  while (exponent-- > 0) power *= 10;
  return power;
}

}  // namespace

TextLine& TextLine::text(std::string_view part) {
  const std::size_t taken = complete_ ? std::min(part.size(), capacity - length_) : 0;
  std::copy_n(part.data(), taken, buffer_.data() + length_);
  length_ += taken;
  if (taken < part.size()) complete_ = false;
  return *this;
}

TextLine& TextLine::character(char c) { return text({&c, 1}); }

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
  while (value > UINT32_MAX) {
    reversed[count++] = static_cast<char>('0' + value % 10);
    value /= 10;
  }
  for (auto rest = static_cast<std::uint32_t>(value); rest != 0; rest /= 10) {
    reversed[count++] = static_cast<char>('0' + rest % 10);
  }
  while (count < at_least) reversed[count++] = '0';
  while (count > 0) character(reversed[--count]);
  return *this;
}

void TextLine::clear() {
  length_ = 0;
  complete_ = true;
}

}  // namespace host_link
