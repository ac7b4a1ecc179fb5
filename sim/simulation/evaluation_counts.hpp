// SPDX-License-Identifier: Apache-2.0
// Of the clocks of a Verilated chip: how many were leapt over, how many evaluated, and why.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace sim {

// What comes next after a leap: something in the chip, an access or the end of a run of the
// processor's model, or the time of a device or of the caller.
enum class LeapEnd : std::uint8_t {
  device,
  processor,
  timer,
  converter,
  heater,
  motion_watchdog,
  time_base,
  fan
};

inline constexpr std::size_t leap_end_count = 8;

struct EvaluationCounts {
  std::uint64_t leaps{};
  std::uint64_t leapt_clocks{};
  std::array<std::uint64_t, leap_end_count> leaps_ended_by{};

  std::uint64_t evaluated_clocks{};
  // Of these: every part has an edge after an input has changed, and else those that work. Several
  // may work in one clock; `free_running_alone` where none did, but the next event was too near for
  // a leap.
  std::uint64_t after_input{};
  std::uint64_t processor{}, registers{}, axes{}, peripherals{};
  std::uint64_t free_running_alone{};
};

}  // namespace sim
