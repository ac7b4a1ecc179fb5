// SPDX-License-Identifier: Apache-2.0
// What answers on the bus in the processor's tests: a few words and a register
// of interrupt requests.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

namespace processor {

// 0xF0000000: 64 words that keep what is written, byte by byte.
// 0xF0000100: the interrupt requests, in the bits of mip. Everything else answers with an error.
class TestDevice {
 public:
  static constexpr std::uint32_t base = 0xF0000000;
  static constexpr std::uint32_t interrupt_register = base + 0x100;
  static constexpr std::uint32_t interrupt_mask = 0xFFFF0880;

  std::optional<std::uint32_t> read(std::uint32_t address) const {
    if (address == interrupt_register) return interrupts_;
    if (address - base < 0x100) return words_[(address - base) / 4];
    return std::nullopt;
  }

  // The byte lanes as on the bus. False: refused.
  bool write(std::uint32_t address, unsigned lanes, std::uint32_t data) {
    std::uint32_t mask = 0;
    for (unsigned lane = 0; lane < 4; ++lane) {
      if ((lanes >> lane & 1) != 0) mask |= 0xFFu << (8 * lane);
    }
    if (address == interrupt_register && lanes == 0xF) {
      interrupts_ = data & interrupt_mask;
      return true;
    }
    if (address - base >= 0x100) return false;
    auto& word = words_[(address - base) / 4];
    word = (word & ~mask) | (data & mask);
    return true;
  }

  std::uint32_t interrupts() const { return interrupts_; }
  void set_interrupts(std::uint32_t interrupts) { interrupts_ = interrupts; }

 private:
  std::array<std::uint32_t, 64> words_{};
  std::uint32_t interrupts_ = 0;
};

}  // namespace processor
