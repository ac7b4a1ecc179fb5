// SPDX-License-Identifier: Apache-2.0
// Writes the C++ header of a peripheral's registers: one struct per register with encode and
// decode.
#include <fmt/format.h>

#include <cctype>

#include "register_generator/description.hpp"

namespace register_generator {
namespace {

std::string pascal_case(const std::string& name) {
  std::string result;
  bool upper = true;
  for (const char c : name) {
    if (c == '_') {
      upper = true;
      continue;
    }
    result += upper ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    upper = false;
  }
  return result;
}

std::string type_of(const Field& field) {
  switch (field.type) {
    case FieldType::bit:
      return "bool";
    case FieldType::signed_number:
      return "std::int32_t";
    default:
      return "std::uint32_t";
  }
}

std::string decoded(const Field& field) {
  const std::string shifted = field.lsb == 0 ? "word" : fmt::format("(word >> {}u)", field.lsb);
  const std::string masked =
      field.width() == 32 ? shifted : fmt::format("({} & 0x{:X}u)", shifted, field.mask());
  switch (field.type) {
    case FieldType::bit:
      return fmt::format("{} != 0", masked);
    case FieldType::signed_number: {
      const unsigned spare = 32 - field.width();
      if (spare == 0) return "static_cast<std::int32_t>(word)";
      return fmt::format("static_cast<std::int32_t>({} << {}u) >> {}", shifted, spare, spare);
    }
    default:
      return masked;
  }
}

std::string encoded(const Field& field) {
  std::string value = field.type == FieldType::bit ? fmt::format("({} ? 1u : 0u)", field.name)
                      : field.type == FieldType::signed_number
                          ? fmt::format("static_cast<std::uint32_t>({})", field.name)
                          : field.name;
  if (field.width() < 32 && field.type != FieldType::bit) {
    value = fmt::format("({} & 0x{:X}u)", value, field.mask());
  }
  return field.lsb == 0 ? value : fmt::format("{} << {}u", value, field.lsb);
}

void write_register(std::string& text, const Register& r) {
  const std::string type = pascal_case(r.name);
  text += fmt::format("\n// {}\nstruct {} {{\n", r.summary, type);
  if (r.is_array) {
    text += fmt::format("  static constexpr std::size_t count = {};\n", r.count);
    text += fmt::format(
        "  static constexpr std::uint32_t address_of(std::size_t index) {{\n"
        "    return base + 0x{:X}u + 4u * static_cast<std::uint32_t>(index);\n  }}\n",
        r.offset);
  } else {
    text += fmt::format("  static constexpr std::uint32_t address = base + 0x{:X}u;\n", r.offset);
  }
  for (const Field& field : r.fields) {
    if (field.values.empty()) continue;
    text += fmt::format("  enum class {} : std::uint32_t {{\n", pascal_case(field.name));
    for (const auto& [name, value] : field.values)
      text += fmt::format("    {} = {},\n", name, value);
    text += "  };\n";
  }
  for (const Field& field : r.fields) {
    text += fmt::format("  // {}\n  {} {}{{}};\n", field.summary, type_of(field), field.name);
  }
  text +=
      fmt::format("\n  static constexpr {} decode([[maybe_unused]] std::uint32_t word) {{\n", type);
  text += "    return {\n";
  for (const Field& field : r.fields) {
    text += fmt::format("      .{} = {},\n", field.name, decoded(field));
  }
  text += "    };\n  }\n  constexpr std::uint32_t encode() const {\n    return ";
  for (std::size_t i = 0; i < r.fields.size(); ++i) {
    text += (i == 0 ? "" : " |\n           ") + encoded(r.fields[i]);
  }
  text += ";\n  }\n};\n";
}

}  // namespace

std::string cpp_file(const Peripheral& peripheral, const std::string& source) {
  std::string text = fmt::format(
      "// SPDX-License-Identifier: Apache-2.0\n"
      "// Registers of `{0}`. Generated from {1}: do not edit.\n"
      "// clang-format off\n#pragma once\n\n#include <cstddef>\n#include <cstdint>\n\n"
      "// {2}\nnamespace registers::{0} {{\n\n"
      "inline constexpr std::uint32_t base = 0x{3:08X}u;\n",
      peripheral.name, source, peripheral.summary, peripheral.address);
  for (const Register& r : peripheral.registers) write_register(text, r);
  text += fmt::format("\n}}  // namespace registers::{}\n", peripheral.name);
  return text;
}

}  // namespace register_generator
