// SPDX-License-Identifier: Apache-2.0
// The names by which the compiler calls 64-bit division. They take the place of its library's, of
// which each holds a copy of the whole algorithm: 3 KiB that the image cannot spare.
#include <cstdint>

#include "platform/division.hpp"

extern "C" {

std::uint64_t __udivdi3(std::uint64_t dividend, std::uint64_t divisor) {
  return platform::divide(dividend, divisor);
}

std::uint64_t __umoddi3(std::uint64_t dividend, std::uint64_t divisor) {
  return dividend - platform::divide(dividend, divisor) * divisor;
}

std::int64_t __divdi3(std::int64_t dividend, std::int64_t divisor) {
  const auto magnitude = [](std::int64_t value) {
    const auto bits = static_cast<std::uint64_t>(value);
    return value < 0 ? 0 - bits : bits;
  };
  const std::uint64_t quotient = platform::divide(magnitude(dividend), magnitude(divisor));
  return static_cast<std::int64_t>((dividend < 0) == (divisor < 0) ? quotient : 0 - quotient);
}

std::int64_t __moddi3(std::int64_t dividend, std::int64_t divisor) {
  return dividend - __divdi3(dividend, divisor) * divisor;
}

}  // extern "C"
