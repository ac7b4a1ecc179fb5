// SPDX-License-Identifier: Apache-2.0
// Arithmetic of 32 significant bits, with two 32-bit divisions in a quotient and in a root.
#include "motion/scaled.hpp"

#include <array>
#include <bit>
#include <utility>

#include "units/loop_bound.hpp"

namespace motion {

namespace {

// (high * 2^32 + low) / divisor for divisor >= 2^31 and high < divisor, so that the quotient has 32
// bits. Two digits of 16 bits, as in Knuth, The Art of Computer Programming, vol. 2, 4.3.1,
// algorithm D.
std::uint32_t divide(std::uint32_t high, std::uint32_t low, std::uint32_t divisor) {
  const std::uint32_t divisor_high = divisor >> 16;
  const std::uint32_t divisor_low = divisor & 0xFFFF;
  const auto digit = [=](std::uint32_t upper, std::uint32_t next) {
    std::uint32_t quotient = upper / divisor_high;
    std::uint32_t rest = upper - quotient * divisor_high;
    // The divisor's highest bit is 1: the digit is at most 2 too large (theorem B).
    units::LoopBound<2> corrections;
    while (quotient > 0xFFFF || quotient * divisor_low > (rest << 16 | next)) {
      corrections.next();
      --quotient;
      rest += divisor_high;
      if (rest > 0xFFFF) break;
    }
    return quotient;
  };
  const std::uint32_t first = digit(high, low >> 16);
  // Modulo 2^32: the true difference is less than the divisor.
  const std::uint32_t middle = (high << 16 | low >> 16) - first * divisor;
  const std::uint32_t second = digit(middle, low & 0xFFFF);
  return (first << 16) + second;
}

// Root and rest of a number.
struct Root {
  std::uint32_t root;
  std::uint32_t rest;
};

// The roots of 64, 65, ... 255 times 256, rounded down.
constexpr auto byte_roots = [] {
  std::array<std::uint8_t, 192> roots{};
  std::uint32_t root = 128;
  for (std::uint32_t i = 0; i < roots.size(); ++i) {
    while ((root + 1) * (root + 1) <= (i + 64) * 256) ++root;
    roots[i] = static_cast<std::uint8_t>(root);
  }
  return roots;
}();

// The root of a word >= 2^30: half of it from the table, where the lower byte adds at most 1, the
// other half by one division (P. Zimmermann, Karatsuba Square Root, INRIA RR-3805, 1999).
Root root_of_word(std::uint32_t radicand) {
  const std::uint32_t upper = radicand >> 16;
  std::uint32_t half = byte_roots[(upper >> 8) - 64];
  std::uint32_t upper_rest = upper - half * half;
  if (upper_rest > 2 * half) {
    upper_rest -= 2 * half + 1;
    ++half;
  }
  const std::uint32_t numerator = upper_rest << 8 | (radicand >> 8 & 0xFF);
  const std::uint32_t digit = numerator / (2 * half);
  const std::uint32_t root = (half << 8) + digit;
  const std::uint32_t rest = radicand - root * root;
  // A digit that is too large by 1 leaves a rest below 0.
  if ((rest >> 31) != 0) return {root - 1, rest + 2 * root - 1};
  return {root, rest};
}

// The root of high * 2^32 + low for high >= 2^30, likewise from that of the high word.
std::uint32_t root_of_double_word(std::uint32_t high, std::uint32_t low) {
  const Root upper = root_of_word(high);
  const std::uint32_t next = low >> 16;
  const std::uint32_t numerator = (upper.rest << 15) + (next >> 1);
  const std::uint32_t digit = numerator / upper.root;
  const std::uint32_t rest = numerator - digit * upper.root;
  const std::uint64_t root = (std::uint64_t{upper.root} << 16) + digit;
  const std::uint64_t rest_of_all = (std::uint64_t{rest * 2 + (next & 1)} << 16) + (low & 0xFFFF);
  const bool too_large = rest_of_all < std::uint64_t{digit} * digit;
  return static_cast<std::uint32_t>(too_large ? root - 1 : root);
}

}  // namespace

Scaled Scaled::of(std::uint64_t value, int exponent) {
  const auto high = static_cast<std::uint32_t>(value >> 32);
  const auto low = static_cast<std::uint32_t>(value);
  if (high == 0) return of_word(low, exponent);
  const Scaled upper = of_word(high, exponent + 32);
  const int zeros = exponent + 32 - upper.exponent_;
  if (zeros == 0) return upper;
  return Scaled(upper.mantissa_ | low >> (32 - zeros), upper.exponent_);
}

Scaled Scaled::operator*(Scaled factor) const {
  const std::uint64_t product = std::uint64_t{mantissa_} * factor.mantissa_;
  const auto high = static_cast<std::uint32_t>(product >> 32);
  const int exponent = exponent_ + factor.exponent_ + 32;
  if (high >> 31 != 0) return Scaled(high, exponent);
  return Scaled(high << 1 | static_cast<std::uint32_t>(product) >> 31, exponent - 1);
}

Scaled Scaled::operator+(Scaled summand) const {
  Scaled large = *this;
  if (large < summand) std::swap(large, summand);
  const int shift = large.exponent_ - summand.exponent_;
  if (summand.mantissa_ == 0 || shift > 31) return large;
  const std::uint64_t sum = std::uint64_t{large.mantissa_} + (summand.mantissa_ >> shift);
  if (sum >> 32 == 0) return Scaled(static_cast<std::uint32_t>(sum), large.exponent_);
  return Scaled(static_cast<std::uint32_t>(sum >> 1), large.exponent_ + 1);
}

Scaled Scaled::operator/(Scaled divisor) const {
  const int exponent = exponent_ - divisor.exponent_ - 32;
  if (mantissa_ < divisor.mantissa_) {
    return Scaled(divide(mantissa_, 0, divisor.mantissa_), exponent);
  }
  return Scaled(divide(mantissa_ >> 1, mantissa_ << 31, divisor.mantissa_), exponent + 1);
}

Scaled Scaled::square_root() const {
  if (mantissa_ == 0) return {};
  if (exponent_ % 2 == 0) return Scaled(root_of_double_word(mantissa_, 0), exponent_ / 2 - 16);
  return Scaled(root_of_double_word(mantissa_ >> 1, mantissa_ << 31), (exponent_ + 1) / 2 - 16);
}

std::uint64_t Scaled::floor(int scale) const {
  const int shift = exponent_ + scale;
  if (mantissa_ == 0 || shift <= -32) return 0;
  if (shift > 32) return ~std::uint64_t{0};
  return shift < 0 ? mantissa_ >> -shift : std::uint64_t{mantissa_} << shift;
}

std::strong_ordering Scaled::operator<=>(const Scaled& other) const {
  if (mantissa_ == 0 || other.mantissa_ == 0 || exponent_ == other.exponent_) {
    return mantissa_ <=> other.mantissa_;
  }
  return exponent_ <=> other.exponent_;
}

}  // namespace motion
