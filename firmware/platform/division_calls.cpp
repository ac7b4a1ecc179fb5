// SPDX-License-Identifier: Apache-2.0
// The names by which the compiler calls 64-bit division. They take the place of its library's, of
// which each holds a copy of the whole algorithm: 3 KiB that the image cannot spare.
#include <cstdint>

#include "platform/division.hpp"
#include "units/magnitude.hpp"

extern "C" {

std::uint64_t __udivdi3(std::uint64_t dividend, std::uint64_t divisor) {
  return platform::divide(dividend, divisor);
}

std::uint64_t __umoddi3(std::uint64_t dividend, std::uint64_t divisor) {
  return dividend - platform::divide(dividend, divisor) * divisor;
}

std::int64_t __divdi3(std::int64_t dividend, std::int64_t divisor) {
  const std::uint64_t quotient =
      platform::divide(units::magnitude(dividend), units::magnitude(divisor));
  return static_cast<std::int64_t>((dividend < 0) == (divisor < 0) ? quotient : 0 - quotient);
}

std::int64_t __moddi3(std::int64_t dividend, std::int64_t divisor) {
  return dividend - __divdi3(dividend, divisor) * divisor;
}

}  // extern "C"
