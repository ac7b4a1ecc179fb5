// SPDX-License-Identifier: Apache-2.0
// How often a loop goes round at most: a fact for tools/timing, which host tests check.
#pragma once

#include <cstdint>
#include <cstdlib>

namespace units {

// Declared before a loop; `next()` is the first in it. On the chip this is no instruction, only an
// entry in a section that is not loaded. On a host a round too many ends the program.
template <std::uint32_t most>
class LoopBound {
 public:
  [[gnu::always_inline]] inline void next([[maybe_unused]] unsigned line = __builtin_LINE()) {
#ifdef __riscv
    asm volatile(
        ".pushsection .loop_bounds,\"\",@progbits\n"
        ".word 1f, %c0, %c1\n"
        ".popsection\n"
        "1:" ::"i"(most),
        "i"(line));
#else
    if (++rounds_ > most) std::abort();
#endif
  }

#ifndef __riscv
 private:
  std::uint32_t rounds_ = 0;
#endif
};

}  // namespace units
