// SPDX-License-Identifier: Apache-2.0
// Adds one random instruction to a program, or the few that only make sense together.
#pragma once

#include "tests/processor/random_text.hpp"

namespace processor {

// Of 32 bits, of any kind that the settings allow.
void add_random_word(RandomText& text);
// The same of 16 bits.
void add_random_half_word(RandomText& text);
// ecall, ebreak, fences, CSRs and, with interrupts, what raises and allows them.
void add_random_system_instruction(RandomText& text);

}  // namespace processor
