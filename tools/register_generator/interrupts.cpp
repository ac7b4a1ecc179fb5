// SPDX-License-Identifier: Apache-2.0
// The interrupts of all peripherals in one list, for VHDL, C++ and the reader.
#include <fmt/format.h>

#include <algorithm>

#include "register_generator/description.hpp"
#include "register_generator/template.hpp"

namespace register_generator {
namespace {

constexpr std::string_view vhdl_template =
    R"(-- SPDX-License-Identifier: Apache-2.0
-- Numbers of the interrupts. Generated from the descriptions of the peripherals: do not edit.

package interrupts_pkg is
  @numbers@

end package;
)";

constexpr std::string_view cpp_template =
    R"(// SPDX-License-Identifier: Apache-2.0
// Interrupts. Generated from the descriptions of the peripherals: do not edit.
// clang-format off
#pragma once

#include <cstdint>

namespace registers {

// Bits of the processor's registers mie and mip.
enum class Interrupt : std::uint32_t {
  @numbers@
};

}  // namespace registers
)";

constexpr std::string_view markdown_template =
    R"(# Interrupts

Generated from the descriptions of the peripherals: do not edit. The number is the bit in `mie` and
`mip`, and the cause in `mcause`. Of those from 16 on, the lowest number has the highest priority.

| number | name | peripheral | meaning |
|---|---|---|---|
@numbers@
)";

}  // namespace

std::vector<Interrupt> interrupts_of(const std::vector<Peripheral>& peripherals) {
  std::vector<Interrupt> all;
  for (const Peripheral& peripheral : peripherals) {
    for (const Interrupt& interrupt : peripheral.interrupts) {
      for (const Interrupt& other : all) {
        if (other.name != interrupt.name && other.number != interrupt.number) continue;
        throw DescriptionError(fmt::format("{}: interrupt {} ({}) is also {} ({}) of {}",
                                           peripheral.name, interrupt.name, interrupt.number,
                                           other.name, other.number, other.peripheral));
      }
      all.push_back(interrupt);
    }
  }
  std::ranges::sort(all, {}, &Interrupt::number);
  return all;
}

std::string vhdl_interrupts(const std::vector<Interrupt>& interrupts) {
  std::string numbers;
  for (const Interrupt& interrupt : interrupts) {
    numbers += fmt::format("\n-- {}\nconstant {}_interrupt_number : natural := {};\n",
                           interrupt.summary, interrupt.name, interrupt.number);
  }
  return fill(vhdl_template, {{"numbers", numbers}});
}

std::string cpp_interrupts(const std::vector<Interrupt>& interrupts) {
  std::string numbers;
  for (const Interrupt& interrupt : interrupts) {
    numbers +=
        fmt::format("// {}\n{} = 1u << {},\n", interrupt.summary, interrupt.name, interrupt.number);
  }
  return fill(cpp_template, {{"numbers", numbers}});
}

std::string markdown_interrupts(const std::vector<Interrupt>& interrupts) {
  std::string numbers;
  for (const Interrupt& interrupt : interrupts) {
    numbers += fmt::format("| {} | `{}` | [`{}`]({}.md) | {} |\n", interrupt.number, interrupt.name,
                           interrupt.peripheral, interrupt.peripheral, interrupt.summary);
  }
  return fill(markdown_template, {{"numbers", numbers}});
}

}  // namespace register_generator
