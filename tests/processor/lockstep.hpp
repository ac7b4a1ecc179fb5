// SPDX-License-Identifier: Apache-2.0
// Runs a program on the chip and on the instruction-set model side by side,
// instruction by instruction.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/processor/chip.hpp"
#include "tests/processor/instruction_set_model.hpp"

namespace processor {

struct LockstepResult {
  // Empty: no difference; otherwise what differed first.
  std::string difference;
  // What the program stored at `tohost`; 0 where it did not within the limit.
  std::uint32_t tohost = 0;
  std::uint64_t instructions = 0;
  std::uint64_t clocks = 0;
  std::uint64_t traps = 0;
  std::uint64_t interrupts = 0;
};

struct LockstepSettings {
  std::uint32_t tohost_address = 0;
  std::uint64_t max_instructions = 100'000;
  unsigned bus_wait = 1;
  // Interrupts are requested from outside at random times; 0: none.
  std::uint32_t interrupt_seed = 0;
  // While the processor sleeps and the device's first word is `wake_word`, these are requested.
  std::uint32_t wake_word = 0;
  std::uint32_t wake_request = 0;
};

// Whether it reads the counter of clocks, which the model has not.
bool reads_cycle(std::uint32_t instruction);

// Every completed instruction and every trap is compared, and the whole memory at the end.
LockstepResult run_lockstep(const std::vector<std::uint8_t>& image,
                            const LockstepSettings& settings);

}  // namespace processor
