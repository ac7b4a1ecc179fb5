// SPDX-License-Identifier: Apache-2.0
// Classifies an instruction by the rows of the table of times, from its bits and its operands.
#pragma once

#include <cstdint>
#include <optional>

#include "tests/processor/instruction_set_model.hpp"

namespace processor {

struct TimedInstruction {
  // Of rtl/processor/timing.md; for an access, that of the memory or of a peripheral.
  const char* row = "arithmetic and logic";
  // Registers that it reads, 0 for none.
  unsigned first = 0;
  unsigned second = 0;
  bool late = false;
  bool on_bus = false;
  bool sleeps = false;
};

// The instruction at which the model stands; nothing where it is none, or lies outside the memory.
std::optional<TimedInstruction> timed_instruction(const InstructionSetModel& model, bool has_zbb);

}  // namespace processor
