// SPDX-License-Identifier: Apache-2.0
// What a stepper motor driver chip demands of its step and direction inputs, in ns and in clocks.
#pragma once

#include <cstdint>

#include "units/quantity.hpp"

namespace drivers {

// Least times by a chip's data sheet, all at the rising edge of step.
struct DriverChipTimings {
  std::uint32_t high_ns{};
  std::uint32_t low_ns{};
  std::uint32_t direction_setup_ns{};
  std::uint32_t direction_hold_ns{};
};

// Allegro A4988 data sheet, figure 1: t_A, t_B, t_C, t_D.
inline constexpr DriverChipTimings a4988{1000, 1000, 200, 200};
// TI DRV8825 data sheet, timing requirements: t_WH(STEP), t_WL(STEP), t_SU(STEP), t_H(STEP).
inline constexpr DriverChipTimings drv8825{1900, 1900, 650, 650};
// Trinamic TMC2209 and TMC5160 data sheets, step/dir interface at a 12 MHz clock: t_SH, t_SL,
// t_DSU, t_DSH.
inline constexpr DriverChipTimings tmc2209{103, 103, 20, 20};
inline constexpr DriverChipTimings tmc5160{103, 103, 20, 20};

// The same in clocks, 1 .. 4095 each, as the step generator's guard keeps it.
struct GuardTimings {
  static constexpr std::uint32_t longest_clocks = 4095;

  std::uint32_t high{1};
  std::uint32_t low{1};
  std::uint32_t direction_setup{1};
  std::uint32_t direction_hold{1};
  // Each edge of step is a step, for drivers set to that (DEDGE of the TMC2209 and TMC5160):
  // half the edges for the same speed. High and low are then least times. To be changed while
  // step is low.
  bool both_edges{};

  // Never shorter than asked: rounded up. What exceeds the hardware's range becomes its longest.
  static constexpr GuardTimings of(const DriverChipTimings& chip, units::Hertz clock) {
    return {clocks(chip.high_ns, clock), clocks(chip.low_ns, clock),
            clocks(chip.direction_setup_ns, clock), clocks(chip.direction_hold_ns, clock)};
  }

  constexpr bool operator==(const GuardTimings&) const = default;

 private:
  static constexpr std::uint32_t clocks(std::uint32_t time_ns, units::Hertz clock) {
    constexpr std::uint64_t ns_per_second = 1'000'000'000;
    const std::uint64_t rounded_up =
        (std::uint64_t{time_ns} * clock.count() + ns_per_second - 1) / ns_per_second;
    if (rounded_up < 1) return 1;
    return rounded_up > longest_clocks ? longest_clocks : static_cast<std::uint32_t>(rounded_up);
  }
};

static_assert(GuardTimings::of(a4988, units::Hertz{50'000'000}) == GuardTimings{50, 50, 10, 10});
static_assert(GuardTimings::of(drv8825, units::Hertz{50'000'000}) == GuardTimings{95, 95, 33, 33});
static_assert(GuardTimings::of(tmc2209, units::Hertz{50'000'000}) == GuardTimings{6, 6, 1, 1});

}  // namespace drivers
