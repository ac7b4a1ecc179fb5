// SPDX-License-Identifier: Apache-2.0
// Positive numbers of any size with 32 significant bits, in integer arithmetic that a small
// processor does quickly: the planner's lengths, rates and accelerations span 80 binary digits but
// need no more than nine decimal ones.
#pragma once

#include <compare>
#include <cstdint>

namespace motion {

// mantissa * 2^exponent, mantissa in 2^31 .. 2^32 - 1, or 0. Every operation truncates: its
// relative error is below 2^-31. Exponents stay within some hundreds, so they cannot overflow here.
class Scaled {
 public:
  constexpr Scaled() = default;

  // value * 2^exponent
  static Scaled of(std::uint64_t value, int exponent = 0);
  // The same, for what has one word.
  static constexpr Scaled of_word(std::uint32_t value, int exponent = 0) {
    if (value == 0) return {};
    // Without a call: not every processor has an instruction for it.
    if (value >> 16 == 0) value <<= 16, exponent -= 16;
    if (value >> 24 == 0) value <<= 8, exponent -= 8;
    if (value >> 28 == 0) value <<= 4, exponent -= 4;
    if (value >> 30 == 0) value <<= 2, exponent -= 2;
    if (value >> 31 == 0) value <<= 1, exponent -= 1;
    return Scaled(value, exponent);
  }

  Scaled operator*(Scaled factor) const;
  Scaled operator+(Scaled summand) const;
  // The integer part of value * this * 2^scale, which must be below 2^32.
  std::uint32_t floor_of_product(std::uint32_t value, int scale) const {
    const int shift = -(exponent_ + scale + 32);
    const auto high = static_cast<std::uint32_t>((std::uint64_t{value} * mantissa_) >> 32);
    if (shift >= 0) return shift < 32 ? high >> shift : 0;
    return static_cast<std::uint32_t>((std::uint64_t{value} * mantissa_) >> (32 + shift));
  }
  // The divisor must not be 0.
  Scaled operator/(Scaled divisor) const;
  Scaled square_root() const;
  Scaled half() const { return Scaled(mantissa_, exponent_ - 1); }

  // The integer part of this * 2^scale, at most 2^64 - 1.
  std::uint64_t floor(int scale = 0) const;

  // mantissa * 2^exponent, the mantissa 0 or in 2^31 .. 2^32 - 1.
  static constexpr Scaled of_parts(std::uint32_t mantissa, int exponent) {
    return Scaled(mantissa, exponent);
  }
  std::uint32_t mantissa() const { return mantissa_; }
  int exponent() const { return exponent_; }
  // value * mantissa, so that value * this is the result * 2^exponent.
  std::uint64_t product_of_mantissa(std::uint32_t value) const {
    return std::uint64_t{value} * mantissa_;
  }

  bool operator==(const Scaled&) const = default;
  std::strong_ordering operator<=>(const Scaled& other) const;

 private:
  constexpr Scaled(std::uint32_t mantissa, int exponent)
      : mantissa_(mantissa), exponent_(mantissa == 0 ? 0 : exponent) {}

  std::uint32_t mantissa_{};
  std::int32_t exponent_{};
};

}  // namespace motion
