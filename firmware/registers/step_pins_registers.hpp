// SPDX-License-Identifier: Apache-2.0
// Registers of `step_pins`. Generated from rtl/motion/step_pins.toml: do not edit.
// clang-format off
#pragma once

#include <cstddef>
#include <cstdint>

// Step and direction pins in the hands of software instead of the step generator's.
namespace registers::step_pins {

inline constexpr std::uint32_t base = 0xF0008000u;

// Who drives the pins. Changed only where the chip permits software stepping (status.permitted), while the step generator is idle and no step pin would change; refused otherwise.
struct Control {
  static constexpr std::uint32_t address = base + 0x0u;
  static constexpr unsigned software_bit = 0;
  static constexpr std::uint32_t software_mask = 1u << software_bit;
  // 1: the registers step and direction; 0: the step generator, as after reset.
  bool software{};

  [[gnu::always_inline]] static constexpr Control decode([[maybe_unused]] std::uint32_t word) {
    return {
      .software = (word & 0x1u) != 0,
    };
  }
  constexpr std::uint32_t encode() const {
    return (software ? 1u : 0u);
  }
};

// Step pins, bit n for axis n. All change in the same clock.
struct Step {
  static constexpr std::uint32_t address = base + 0x4u;
  static constexpr unsigned pins_low = 0, pins_width = 8;
  static constexpr std::uint32_t pins_max = 0xFFu, pins_mask = pins_max << pins_low;
  // 1: high.
  std::uint32_t pins{};

  [[gnu::always_inline]] static constexpr Step decode([[maybe_unused]] std::uint32_t word) {
    return {
      .pins = (word & 0xFFu),
    };
  }
  constexpr std::uint32_t encode() const {
    return (pins & 0xFFu);
  }
};

// Direction pins, bit n for axis n.
struct Direction {
  static constexpr std::uint32_t address = base + 0x8u;
  static constexpr unsigned pins_low = 0, pins_width = 8;
  static constexpr std::uint32_t pins_max = 0xFFu, pins_mask = pins_max << pins_low;
  // 1: high, negative direction.
  std::uint32_t pins{};

  [[gnu::always_inline]] static constexpr Direction decode([[maybe_unused]] std::uint32_t word) {
    return {
      .pins = (word & 0xFFu),
    };
  }
  constexpr std::uint32_t encode() const {
    return (pins & 0xFFu);
  }
};

// Emergency stop: works without software.
struct Stop {
  static constexpr std::uint32_t address = base + 0xCu;
  static constexpr unsigned stopped_bit = 0;
  static constexpr std::uint32_t stopped_mask = 1u << stopped_bit;
  // 1: the input was active, so no step pin rises; a write of 1 while it is not permits it again.
  bool stopped{};

  [[gnu::always_inline]] static constexpr Stop decode([[maybe_unused]] std::uint32_t word) {
    return {
      .stopped = (word & 0x1u) != 0,
    };
  }
  constexpr std::uint32_t encode() const {
    return (stopped ? 1u : 0u);
  }
};

// Whether software may drive the pins.
struct Status {
  static constexpr std::uint32_t address = base + 0x10u;
  static constexpr unsigned permitted_bit = 0;
  static constexpr std::uint32_t permitted_mask = 1u << permitted_bit;
  static constexpr unsigned refused_bit = 1;
  static constexpr std::uint32_t refused_mask = 1u << refused_bit;
  // 1: the input software_stepping of the chip is high, as only a co-simulation has it. 0: the pins are the step generator's, and writes have no effect on them.
  bool permitted{};
  // 1: a change of control was refused; a write of 1 clears it.
  bool refused{};

  [[gnu::always_inline]] static constexpr Status decode([[maybe_unused]] std::uint32_t word) {
    return {
      .permitted = (word & 0x1u) != 0,
      .refused = ((word >> 1u) & 0x1u) != 0,
    };
  }
  constexpr std::uint32_t encode() const {
    return (permitted ? 1u : 0u) |
           (refused ? 1u : 0u) << 1u;
  }
};

}  // namespace registers::step_pins
