// SPDX-License-Identifier: Apache-2.0
// What the firmware counts about itself. The simulation reads it from memory by
// the symbol `statistics`.
#pragma once

#include <array>
#include <cstdint>

#include "units/task_span.hpp"

namespace application {

// Of a task of the main loop, since the reset.
struct TaskTimes {
  std::uint32_t longest_clocks{};
  std::uint32_t overruns{};  // of its budget
};

// The layout is a contract with the simulation: words only, new ones at the end, and then
// a new version.
struct Statistics {
  static constexpr std::uint32_t current_version = 4;

  std::uint32_t version{};  // word 0; 0 until the firmware has started
  std::uint32_t commands_executed{};  // word 1: G-code commands carried out; not those refused
  std::uint32_t commands_refused{};  // word 2: malformed, unknown, out of bounds
  std::uint32_t
      lines_accepted{};  // word 3: by the host link; at once, the others ten times a second
  std::uint32_t resends{};  // word 4: asked of the host
  std::uint32_t underruns{};  // word 5: queue empty at speed
  std::uint32_t guard_stall_clocks{};  // word 6: by which the guard has delayed the common base
  std::uint32_t max_queue_level{};  // word 7: of the step generator's queue
  std::uint32_t segments{};  // word 8: begun by the step generator
  std::uint32_t halted{};  // word 9: 1 after a fault or M112
  std::uint32_t uart_overruns{};  // word 10: bytes lost before the firmware saw them
  std::uint32_t longest_pass_clocks{};  // word 11: longest time from one wake-up to the next sleep
  // Word 12: address of the ring of 8 slots in which accepted line n (from 0) lies in slot n % 8:
  // 128 bytes of text, its number (32 bits), its length (8 bits), whether it has a number (8 bits),
  // 2 more bytes.
  std::uint32_t accepted_lines{};
  std::uint32_t lines_withdrawn{};  // word 13: accepted, but requested again instead of executed
  // Words 14 on, two for each task in the order of a pass.
  std::array<TaskTimes, units::task_count> tasks{};
};

}  // namespace application

extern "C" {
extern application::Statistics statistics;
}
