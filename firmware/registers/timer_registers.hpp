// SPDX-License-Identifier: Apache-2.0
// Registers of `timer`. Generated from rtl/processor/timer.toml: do not edit.
// clang-format off
#pragma once

#include <cstddef>
#include <cstdint>

// Machine timer: counts clocks and interrupts at a deadline.
namespace registers::timer {

inline constexpr std::uint32_t base = 0xF0002000u;

// Low word: Clocks since reset. Reading the low word holds the high word of the same instant.
struct TimeLow {
  static constexpr std::uint32_t address = base + 0x0u;
  static constexpr unsigned cycles_low = 0, cycles_width = 32;
  static constexpr std::uint32_t cycles_max = 0xFFFFFFFFu, cycles_mask = cycles_max << cycles_low;
  // Clocks. Bits 31:0.
  std::uint32_t cycles{};

  [[gnu::always_inline]] static constexpr TimeLow decode([[maybe_unused]] std::uint32_t word) {
    return {
      .cycles = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return cycles;
  }
};

// High word: Clocks since reset. Reading the low word holds the high word of the same instant.
struct TimeHigh {
  static constexpr std::uint32_t address = base + 0x4u;
  static constexpr unsigned cycles_low = 0, cycles_width = 32;
  static constexpr std::uint32_t cycles_max = 0xFFFFFFFFu, cycles_mask = cycles_max << cycles_low;
  // Clocks. Bits 63:32.
  std::uint32_t cycles{};

  [[gnu::always_inline]] static constexpr TimeHigh decode([[maybe_unused]] std::uint32_t word) {
    return {
      .cycles = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return cycles;
  }
};

// Low word: The deadline. It takes effect with the write of the high word; from then on the interrupt is on, until a later one is set.
struct CompareLow {
  static constexpr std::uint32_t address = base + 0x8u;
  static constexpr unsigned cycles_low = 0, cycles_width = 32;
  static constexpr std::uint32_t cycles_max = 0xFFFFFFFFu, cycles_mask = cycles_max << cycles_low;
  // Clocks since reset. Bits 31:0.
  std::uint32_t cycles{};

  [[gnu::always_inline]] static constexpr CompareLow decode([[maybe_unused]] std::uint32_t word) {
    return {
      .cycles = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return cycles;
  }
};

// High word: The deadline. It takes effect with the write of the high word; from then on the interrupt is on, until a later one is set.
struct CompareHigh {
  static constexpr std::uint32_t address = base + 0xCu;
  static constexpr unsigned cycles_low = 0, cycles_width = 32;
  static constexpr std::uint32_t cycles_max = 0xFFFFFFFFu, cycles_mask = cycles_max << cycles_low;
  // Clocks since reset. Bits 63:32.
  std::uint32_t cycles{};

  [[gnu::always_inline]] static constexpr CompareHigh decode([[maybe_unused]] std::uint32_t word) {
    return {
      .cycles = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return cycles;
  }
};

// Clocks since reset. Reading the low word holds the high word of the same instant. Two words.
struct Time {
  using Low = TimeLow;
  using High = TimeHigh;
  std::uint64_t cycles{};

  [[gnu::always_inline]] static constexpr Time decode(Low low, High high) {
    return {.cycles = static_cast<std::uint64_t>(std::uint64_t{high.cycles} << 32 | low.cycles)};
  }
  constexpr Low low() const { return {.cycles = static_cast<std::uint32_t>(cycles)}; }
  constexpr High high() const {
    return {.cycles = static_cast<std::uint32_t>(static_cast<std::uint64_t>(cycles) >> 32)};
  }
};

// The deadline. It takes effect with the write of the high word; from then on the interrupt is on, until a later one is set. Two words.
struct Compare {
  using Low = CompareLow;
  using High = CompareHigh;
  std::uint64_t cycles{};

  [[gnu::always_inline]] static constexpr Compare decode(Low low, High high) {
    return {.cycles = static_cast<std::uint64_t>(std::uint64_t{high.cycles} << 32 | low.cycles)};
  }
  constexpr Low low() const { return {.cycles = static_cast<std::uint32_t>(cycles)}; }
  constexpr High high() const {
    return {.cycles = static_cast<std::uint32_t>(static_cast<std::uint64_t>(cycles) >> 32)};
  }
};

}  // namespace registers::timer
