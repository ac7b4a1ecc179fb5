// SPDX-License-Identifier: Apache-2.0
// Registers of `fan`. Generated from rtl/thermal/fan.toml: do not edit.
// clang-format off
#pragma once

#include <cstddef>
#include <cstdint>

// Fan: one pulse-width modulated output.
namespace registers::fan {

inline constexpr std::uint32_t base = 0xF0007000u;

// How much of the time the fan is on. Taken over at the start of a period.
struct Duty {
  static constexpr std::uint32_t address = base + 0x0u;
  static constexpr unsigned slots_low = 0, slots_width = 8;
  static constexpr std::uint32_t slots_max = 0xFFu, slots_mask = slots_max << slots_low;
  // Slots of the 255 of a period in which the fan is on: 0 is off, 255 is always on.
  std::uint32_t slots{};

  [[gnu::always_inline]] static constexpr Duty decode([[maybe_unused]] std::uint32_t word) {
    return {
      .slots = (word & 0xFFu),
    };
  }
  constexpr std::uint32_t encode() const {
    return (slots & 0xFFu);
  }
};

// How long a period is.
struct Period {
  static constexpr std::uint32_t address = base + 0x4u;
  static constexpr unsigned slot_cycles_low = 0, slot_cycles_width = 24;
  static constexpr std::uint32_t slot_cycles_max = 0xFFFFFFu, slot_cycles_mask = slot_cycles_max << slot_cycles_low;
  // Clocks of one slot, a 255th of a period; 0 acts as 1.
  std::uint32_t slot_cycles{};

  [[gnu::always_inline]] static constexpr Period decode([[maybe_unused]] std::uint32_t word) {
    return {
      .slot_cycles = (word & 0xFFFFFFu),
    };
  }
  constexpr std::uint32_t encode() const {
    return (slot_cycles & 0xFFFFFFu);
  }
};

}  // namespace registers::fan
