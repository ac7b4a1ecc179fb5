// SPDX-License-Identifier: Apache-2.0
// Instructions of all rows of the table of times, and programs around a few of them.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/processor/encode.hpp"

namespace processor {

// An instruction that goes on with the next, whatever it is. `late_result` is what it writes.
struct Kind {
  const char* row;
  encode::Word word;
  bool late = false;
  // It reads mepc, mtvec or place_address as the next instruction's address.
  bool placed = false;
};

// All of this processor: what is an instruction with Zbb only is an exception without.
const std::vector<Kind>& kinds_of_instructions();

namespace timed {
// Registers with a meaning in these programs.
inline constexpr encode::Word data_base = 31, bus_base = 30, late_result = 15, place_address = 28;
inline constexpr encode::Word short_data_base = 8, stack_pointer = 2;
// Where the instructions under test begin, from the start of the memory.
inline constexpr encode::Word program_bytes = 256;
}  // namespace timed

// Where the instructions under test lie, and what is after them.
struct Placed {
  std::vector<std::uint8_t> image;
  encode::Word before = 0;
  encode::Word first = 0;
  encode::Word next = 0;
};

// The first of them lies at the start of a word or, `in_the_middle`, at its second half.
// With a handler interrupts are let through, and traps go there; otherwise they go
// after the instructions.
Placed place(const std::vector<encode::Word>& tested, bool in_the_middle, encode::Word handler = 0);

}  // namespace processor
