// SPDX-License-Identifier: Apache-2.0
// CRC-32 as in Ethernet and zip (polynomial 0x04C11DB7 reflected, begun and ended with all ones),
// by half bytes: a table of 64 bytes.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace boot_loader {

class Checksum {
 public:
  constexpr void add(std::uint8_t byte) {
    state_ ^= byte;
    state_ = state_ >> 4 ^ table[state_ & 15];
    state_ = state_ >> 4 ^ table[state_ & 15];
  }
  constexpr void add(std::span<const std::uint8_t> bytes) {
    for (const std::uint8_t byte : bytes) add(byte);
  }
  constexpr std::uint32_t value() const { return ~state_; }

 private:
  static constexpr std::uint32_t polynomial = 0xEDB88320;
  static constexpr std::array<std::uint32_t, 16> table = [] {
    std::array<std::uint32_t, 16> entries{};
    for (std::uint32_t index = 0; index < 16; ++index) {
      std::uint32_t value = index;
      for (int bit = 0; bit < 4; ++bit) {
        value = (value & 1) != 0 ? value >> 1 ^ polynomial : value >> 1;
      }
      entries[index] = value;
    }
    return entries;
  }();

  std::uint32_t state_ = ~std::uint32_t{0};
};

constexpr std::uint32_t checksum_of(std::span<const std::uint8_t> bytes) {
  Checksum checksum;
  checksum.add(bytes);
  return checksum.value();
}

}  // namespace boot_loader
