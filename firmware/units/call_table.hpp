// SPDX-License-Identifier: Apache-2.0
// Which functions a call through a pointer may reach: a fact for tools/timing.
#pragma once

#include <type_traits>

namespace units {

// In the function that calls one, or in what is inlined there: its pointer comes from this table.
// No instruction on the chip, only an entry in a section that is not loaded.
template <const auto& table>
[[gnu::always_inline]] inline void declare_call_by() {
  static_assert(std::is_const_v<std::remove_reference_t<decltype(table)>>);
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
