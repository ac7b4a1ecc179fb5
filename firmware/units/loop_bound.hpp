// SPDX-License-Identifier: Apache-2.0
// How often a loop goes round at most: a fact for tools/timing, which host tests check.
#pragma once

#include <cstdint>
#include <cstdlib>

namespace units {

// Declared before a loop; `next()` is the first in each of its rounds. On the chip these are no
// instructions, only entries in a section that is not loaded: the place of each next(), and where
// the bound ends. On a host a round too many ends the program.
//
// Bounds of the same number need different tags where one loop lies in another, or follows it
// without anything between them.
template <std::uint32_t most, std::uint32_t tag = 0>
class LoopBound {
 public:
  constexpr LoopBound() = default;
  LoopBound(const LoopBound&) = delete;
  LoopBound& operator=(const LoopBound&) = delete;
  [[gnu::always_inline]] constexpr ~LoopBound() {
#ifdef __riscv
    if !consteval {
      mark<1>();
    }
#endif
  }

  [[gnu::always_inline]] constexpr void next() {
#ifdef __riscv
    if !consteval {
      mark<0>();
    }
#else
    if (++rounds_ > most) std::abort();
#endif
  }

 private:
#ifdef __riscv
  template <std::uint32_t is_end>
  [[gnu::always_inline]] static inline void mark() {
    asm inline volatile(
        ".pushsection .debug_loop_bounds,\"\",@progbits\n"
        ".word 1f, %0, %1, %2\n"
        ".popsection\n"
        "1:" ::"i"(most),
        "i"(tag), "i"(is_end));
  }
#else
  std::uint32_t rounds_ = 0;
#endif
};

}  // namespace units
