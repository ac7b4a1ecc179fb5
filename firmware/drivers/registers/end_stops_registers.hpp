// SPDX-License-Identifier: Apache-2.0
// Registers of `end_stops`. Generated from rtl/motion/end_stops.toml: do not edit.
// clang-format off
#pragma once

#include <cstddef>
#include <cstdint>

// End stop switches: synchronised, filtered, and passed to the step generator.
namespace registers::end_stops {

inline constexpr std::uint32_t base = 0xF0004000u;

// Levels of the eight inputs at each stage, bit n for input n.
struct Status {
  static constexpr std::uint32_t address = base + 0x0u;
  // Pin levels, synchronised only.
  std::uint32_t raw{};
  // Pin levels after the filter.
  std::uint32_t filtered{};
  // What the step generator sees: filtered, of the right polarity, and enabled.
  std::uint32_t triggered{};

  static constexpr Status decode([[maybe_unused]] std::uint32_t word) {
    return {
      .raw = (word & 0xFFu),
      .filtered = ((word >> 8u) & 0xFFu),
      .triggered = ((word >> 16u) & 0xFFu),
    };
  }
  constexpr std::uint32_t encode() const {
    return (raw & 0xFFu) |
           (filtered & 0xFFu) << 8u |
           (triggered & 0xFFu) << 16u;
  }
};

// How long a level must be stable.
struct Filter {
  static constexpr std::uint32_t address = base + 0x4u;
  // Clocks for which a new level must last before it counts; also the delay of the filter.
  std::uint32_t cycles{};

  static constexpr Filter decode([[maybe_unused]] std::uint32_t word) {
    return {
      .cycles = (word & 0xFFFFu),
    };
  }
  constexpr std::uint32_t encode() const {
    return (cycles & 0xFFFFu);
  }
};

// Which level means triggered.
struct Polarity {
  static constexpr std::uint32_t address = base + 0x8u;
  // 1: the switch is triggered while its pin is low.
  std::uint32_t active_low{};

  static constexpr Polarity decode([[maybe_unused]] std::uint32_t word) {
    return {
      .active_low = (word & 0xFFu),
    };
  }
  constexpr std::uint32_t encode() const {
    return (active_low & 0xFFu);
  }
};

// Which inputs have a switch.
struct Enable {
  static constexpr std::uint32_t address = base + 0xCu;
  // 1: the input counts. 0: it is never triggered.
  std::uint32_t inputs{};

  static constexpr Enable decode([[maybe_unused]] std::uint32_t word) {
    return {
      .inputs = (word & 0xFFu),
    };
  }
  constexpr std::uint32_t encode() const {
    return (inputs & 0xFFu);
  }
};

}  // namespace registers::end_stops
