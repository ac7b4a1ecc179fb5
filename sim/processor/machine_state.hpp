// SPDX-License-Identifier: Apache-2.0
// The state of the processor between two instructions, without its memory, and its interrupt lines.
#pragma once

#include <array>
#include <cstdint>

#include "sim/processor/decoder.hpp"

namespace processor {

using Clock = std::uint64_t;

// A counter that advances by itself unless it is stopped: its value at a place of what it counts.
struct RunningCounter {
  std::uint64_t value{};
  std::uint64_t place{};
  bool stopped{};

  std::uint64_t at(std::uint64_t now) const { return stopped ? value : value + (now - place); }
  void set(std::uint64_t now, std::uint64_t new_value) {
    value = new_value;
    place = now;
  }
};

struct MachineState {
  // x0 is 0; writes to it go to the last one.
  std::array<std::uint32_t, no_register + 1> registers{};
  std::uint32_t program_counter = 0x8000'0000;

  // The clock in which the next instruction begins to execute.
  Clock begins = 0;
  // In no earlier clock an interrupt can be taken.
  Clock open_from = 0;
  std::uint8_t late_register = no_register;
  bool accesses = false;
  bool asleep = false;  // a wfi executes since `begins`
  Clock access_clock = 0;

  // The interrupt lines, and the first clock in which their level acts.
  std::uint32_t lines = 0;
  Clock lines_seen = 0;

  bool interrupt_enable = false, previous_interrupt_enable = false;  // mstatus
  std::uint32_t interrupts_enabled = 0;  // mie
  std::uint32_t trap_vector = 0, scratch = 0;
  std::uint32_t exception_address = 0, trap_cause = 0, trap_value = 0;
  RunningCounter cycles;  // by clocks
  RunningCounter retired;  // by `instructions`

  std::uint64_t instructions = 0;
  std::uint64_t traps = 0;
  std::uint64_t slept_clocks = 0;
};

}  // namespace processor
