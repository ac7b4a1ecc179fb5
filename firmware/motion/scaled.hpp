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

  Scaled operator*(Scaled factor) const;
  // The divisor must not be 0.
  Scaled operator/(Scaled divisor) const;
  Scaled square_root() const;
  Scaled half() const { return Scaled(mantissa_, exponent_ - 1); }

  // The integer part of this * 2^scale, at most 2^64 - 1.
  std::uint64_t floor(int scale = 0) const;

  bool operator==(const Scaled&) const = default;
  std::strong_ordering operator<=>(const Scaled& other) const;

 private:
  constexpr Scaled(std::uint32_t mantissa, int exponent)
      : mantissa_(mantissa), exponent_(mantissa == 0 ? 0 : exponent) {}

  std::uint32_t mantissa_{};
  std::int32_t exponent_{};
};

}  // namespace motion
