// SPDX-License-Identifier: Apache-2.0
// The names by which the compiler counts leading zeros where the processor has no instruction for
// it (Zbb). They take the place of its library's, which look into a table of 256 bytes.
#include <cstdint>

extern "C" {

// 1 <= value
int __clzsi2(std::uint32_t value) {
  int zeros = 0;
  if (value >> 16 == 0) value <<= 16, zeros += 16;
  if (value >> 24 == 0) value <<= 8, zeros += 8;
  if (value >> 28 == 0) value <<= 4, zeros += 4;
  if (value >> 30 == 0) value <<= 2, zeros += 2;
  return zeros + static_cast<int>(1 - (value >> 31));
}

// 1 <= value
int __clzdi2(std::uint64_t value) {
  const auto high = static_cast<std::uint32_t>(value >> 32);
  return high != 0 ? __clzsi2(high) : 32 + __clzsi2(static_cast<std::uint32_t>(value));
}

}  // extern "C"
