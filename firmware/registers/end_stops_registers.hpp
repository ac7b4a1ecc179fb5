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
  static constexpr unsigned raw_low = 0, raw_width = 8;
  static constexpr std::uint32_t raw_max = 0xFFu, raw_mask = raw_max << raw_low;
  static constexpr unsigned filtered_low = 8, filtered_width = 8;
  static constexpr std::uint32_t filtered_max = 0xFFu, filtered_mask = filtered_max << filtered_low;
  static constexpr unsigned triggered_low = 16, triggered_width = 8;
  static constexpr std::uint32_t triggered_max = 0xFFu, triggered_mask = triggered_max << triggered_low;
  // Pin levels, synchronised only.
  std::uint32_t raw{};
  // Pin levels after the filter.
  std::uint32_t filtered{};
  // What the step generator sees: filtered, of the right polarity, and enabled.
  std::uint32_t triggered{};

  [[gnu::always_inline]] static constexpr Status decode([[maybe_unused]] std::uint32_t word) {
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
  static constexpr unsigned cycles_low = 0, cycles_width = 16;
  static constexpr std::uint32_t cycles_max = 0xFFFFu, cycles_mask = cycles_max << cycles_low;
  // Clocks for which a new level must last before it counts; also the delay of the filter.
  std::uint32_t cycles{};

  [[gnu::always_inline]] static constexpr Filter decode([[maybe_unused]] std::uint32_t word) {
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
  static constexpr unsigned active_low_low = 0, active_low_width = 8;
  static constexpr std::uint32_t active_low_max = 0xFFu, active_low_mask = active_low_max << active_low_low;
  // 1: the switch is triggered while its pin is low.
  std::uint32_t active_low{};

  [[gnu::always_inline]] static constexpr Polarity decode([[maybe_unused]] std::uint32_t word) {
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
  static constexpr unsigned inputs_low = 0, inputs_width = 8;
  static constexpr std::uint32_t inputs_max = 0xFFu, inputs_mask = inputs_max << inputs_low;
  // 1: the input counts. 0: it is never triggered.
  std::uint32_t inputs{};

  [[gnu::always_inline]] static constexpr Enable decode([[maybe_unused]] std::uint32_t word) {
    return {
      .inputs = (word & 0xFFu),
    };
  }
  constexpr std::uint32_t encode() const {
    return (inputs & 0xFFu);
  }
};

}  // namespace registers::end_stops
