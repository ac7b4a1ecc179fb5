// SPDX-License-Identifier: Apache-2.0
// Division with digits of 16 and 32 bits (Knuth, The Art of Computer Programming 2, 4.3.1,
// algorithm D; for long divisors Warren, Hacker's Delight, 9-5).
#include "platform/division.hpp"

#include <bit>

#include "units/loop_bound.hpp"

namespace platform {
namespace {

constexpr unsigned word_bits = 32;
constexpr unsigned half_bits = 16;
constexpr std::uint32_t half_mask = 0xFFFF;

// One digit of 16 bits: of rest * 2^16 + next over a divisor whose highest bit is 1;
// rest < divisor.
std::uint32_t half_digit(std::uint32_t& rest, std::uint32_t next, std::uint32_t divisor) {
  const std::uint32_t high = divisor >> half_bits;
  std::uint32_t digit = rest / high;
  std::uint32_t over = rest % high;
  // The divisor's highest bit is 1: the digit is at most 2 too large (theorem B).
  units::LoopBound<2> corrections;
  while (digit > half_mask || digit * (divisor & half_mask) > (over << half_bits | next)) {
    corrections.next();
    --digit;
    over += high;
    if (over > half_mask) break;
  }
  rest = (rest << half_bits | next) - digit * divisor;
  return digit;
}

// high < divisor
std::uint32_t divide_word(std::uint32_t high, std::uint32_t low, std::uint32_t divisor) {
  const auto shift = static_cast<unsigned>(std::countl_zero(divisor));
  std::uint32_t rest = high;
  if (shift != 0) {
    rest = high << shift | low >> (word_bits - shift);
    low <<= shift;
    divisor <<= shift;
  }
  const std::uint32_t upper = half_digit(rest, low >> half_bits, divisor);
  return upper << half_bits | half_digit(rest, low & half_mask, divisor);
}

}  // namespace

std::uint64_t divide(std::uint64_t dividend, std::uint64_t divisor) {
  const auto dividend_high = static_cast<std::uint32_t>(dividend >> word_bits);
  const auto divisor_high = static_cast<std::uint32_t>(divisor >> word_bits);
  const auto divisor_low = static_cast<std::uint32_t>(divisor);
  if (divisor_high == 0) {
    if (divisor_low == 0) return ~std::uint64_t{0};
    const std::uint32_t high = dividend_high / divisor_low;
    const std::uint32_t low =
        divide_word(dividend_high % divisor_low, static_cast<std::uint32_t>(dividend), divisor_low);
    return std::uint64_t{high} << word_bits | low;
  }
  // The quotient fits a word. It is estimated with the divisor's upper 32 bits, at most
  // 1 too large.
  const auto shift = static_cast<unsigned>(std::countl_zero(divisor_high));
  const std::uint64_t half = dividend >> 1;
  const auto upper = static_cast<std::uint32_t>(divisor << shift >> word_bits);
  std::uint32_t quotient = divide_word(static_cast<std::uint32_t>(half >> word_bits),
                                       static_cast<std::uint32_t>(half), upper);
  quotient >>= word_bits - 1 - shift;
  if (quotient != 0) --quotient;
  if (dividend - quotient * divisor >= divisor) ++quotient;
  return quotient;
}

}  // namespace platform
