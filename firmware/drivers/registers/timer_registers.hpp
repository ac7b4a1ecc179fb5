// SPDX-License-Identifier: Apache-2.0
// Registers of `timer`. Generated from rtl/processor/timer.toml: do not edit.
// clang-format off
#pragma once

#include <cstddef>
#include <cstdint>

// Machine timer: counts clocks and interrupts at a deadline.
namespace registers::timer {

inline constexpr std::uint32_t base = 0xF0002000u;

// Clocks since reset, low half. Reading it holds the high half of the same instant.
struct TimeLow {
  static constexpr std::uint32_t address = base + 0x0u;
  // Bits 31 to 0.
  std::uint32_t cycles{};

  static constexpr TimeLow decode([[maybe_unused]] std::uint32_t word) {
    return {
      .cycles = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return cycles;
  }
};

// High half of the time at which `time_low` was last read.
struct TimeHigh {
  static constexpr std::uint32_t address = base + 0x4u;
  // Bits 63 to 32.
  std::uint32_t cycles{};

  static constexpr TimeHigh decode([[maybe_unused]] std::uint32_t word) {
    return {
      .cycles = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return cycles;
  }
};

// Low half of the deadline. It takes effect with the next write of `compare_high`.
struct CompareLow {
  static constexpr std::uint32_t address = base + 0x8u;
  // Bits 31 to 0.
  std::uint32_t cycles{};

  static constexpr CompareLow decode([[maybe_unused]] std::uint32_t word) {
    return {
      .cycles = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return cycles;
  }
};

// High half of the deadline. From then on the interrupt is on, until a later one is set.
struct CompareHigh {
  static constexpr std::uint32_t address = base + 0xCu;
  // Bits 63 to 32.
  std::uint32_t cycles{};

  static constexpr CompareHigh decode([[maybe_unused]] std::uint32_t word) {
    return {
      .cycles = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return cycles;
  }
};

}  // namespace registers::timer
