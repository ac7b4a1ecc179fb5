// SPDX-License-Identifier: Apache-2.0
// Writes the chapter of a peripheral's registers.
#include <fmt/format.h>

#include "register_generator/description.hpp"

namespace register_generator {
namespace {

const char* name_of(Access access) {
  switch (access) {
    case Access::read:
      return "read";
    case Access::write:
      return "write";
    case Access::read_write:
      return "read, write";
    case Access::external:
      return "read, write (by the hardware's rules)";
  }
  return "";
}

std::string bits_of(const Field& field) {
  return field.msb == field.lsb ? fmt::format("{}", field.lsb)
                                : fmt::format("{}:{}", field.msb, field.lsb);
}

}  // namespace

std::string markdown_file(const Peripheral& peripheral, const std::string& source) {
  std::string text = fmt::format(
      "# `{}` registers\n\n{}\n\nBase address `0x{:08X}`. Generated from `{}`: do not edit.\n"
      "Registers are written as whole words; anything else is a bus error. A load of a "
      "byte or half word reads the whole word.\n",
      peripheral.name, peripheral.summary, peripheral.address, source);
  if (!peripheral.constants.empty()) text += "\n| constant | value | meaning |\n|---|---|---|\n";
  for (const Constant& constant : peripheral.constants) {
    text += fmt::format("| `{}` | {} | {} |\n", constant.name, constant.value, constant.summary);
  }
  for (const Register& r : peripheral.registers) {
    const std::string place = r.is_array
                                  ? fmt::format("0x{:03X} + 4·i, i = 0…{}", r.offset, r.count - 1)
                                  : fmt::format("0x{:03X}", r.offset);
    text += fmt::format("\n## {} `{}` ({})\n\n{}\n", place, r.name, name_of(r.access), r.summary);
    if (r.read_event) text += "Reading has an effect in the hardware.\n";
    text += "\n| bits | field | reset | meaning |\n|---|---|---|---|\n";
    for (const Field& field : r.fields) {
      std::string meaning = field.summary;
      for (const auto& [name, value] : field.values) {
        meaning += fmt::format(" `{}` = {}.", name, value);
      }
      text += fmt::format("| {} | `{}` | {} | {} |\n", bits_of(field), field.name,
                          r.stored() ? fmt::format("{}", field.reset) : "", meaning);
    }
  }
  return text;
}

}  // namespace register_generator
