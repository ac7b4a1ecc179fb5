// SPDX-License-Identifier: Apache-2.0
// Which functions a call through a pointer may reach: a fact for tools/timing.
#pragma once

namespace units {

// In the function that calls one: its pointer comes from this table, a constant. No instruction on
// the chip, only an entry in a section that is not loaded.
template <const auto& table>
[[gnu::always_inline]] inline void declare_call_by() {
#ifdef __riscv
  asm inline volatile(
      ".pushsection .call_tables,\"\",@progbits\n"
      ".word 1f, %0, %c1\n"
      ".popsection\n"
      "1:" ::"i"(&table),
      "i"(sizeof table));
#endif
}

}  // namespace units
