// SPDX-License-Identifier: Apache-2.0
// The complete state of the chip at a clock in which its processor sleeps.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/simulation/chip.hpp"

namespace replay {

// What a program sees of the processor. Asleep in wfi, with nothing under way, it has no other
// state that matters.
struct ProcessorSnapshot {
  std::array<std::uint32_t, 32> registers{};
  std::uint32_t program_counter{};  // of the wfi
  std::uint32_t mstatus{}, mie{}, mtvec{}, mscratch{}, mepc{}, mcause{}, mtval{}, mcountinhibit{};
  // As an instruction of the next clock reads them.
  std::uint64_t mcycle{}, minstret{};
};

struct Snapshot {
  sim::Clock clock{};
  // In reset, before its first clock: of what follows only the memory counts.
  bool in_reset{};
  ProcessorSnapshot processor;
  std::vector<std::uint32_t> memory;  // words, from its first address
  // The registers and memories outside the processor, in the order of chip_registers.inc.
  std::vector<std::uint8_t> registers;
  sim::OutputPins outputs;
  sim::ProcessorStatistics statistics;
};

}  // namespace replay
