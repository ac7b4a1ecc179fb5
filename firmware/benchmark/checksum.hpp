// SPDX-License-Identifier: Apache-2.0
// CRC-16 (polynomial x^16 + x^15 + x^2 + 1, lowest bit first), bit by bit: a workload, and the
// check of its result.
#pragma once

#include <cstdint>

namespace benchmark {

constexpr std::uint16_t add_byte(std::uint16_t sum, std::uint8_t byte) {
  std::uint32_t value = sum ^ byte;
  for (int bit = 0; bit < 8; ++bit) value = (value & 1) != 0 ? value >> 1 ^ 0xA001u : value >> 1;
  return static_cast<std::uint16_t>(value);
}

constexpr std::uint16_t add_half_word(std::uint16_t sum, std::uint16_t value) {
  return add_byte(add_byte(sum, static_cast<std::uint8_t>(value)),
                  static_cast<std::uint8_t>(value >> 8));
}

constexpr std::uint16_t add_word(std::uint16_t sum, std::uint32_t value) {
  return add_half_word(add_half_word(sum, static_cast<std::uint16_t>(value)),
                       static_cast<std::uint16_t>(value >> 16));
}

}  // namespace benchmark
