// SPDX-License-Identifier: Apache-2.0
// Generates the C++ header of a peripheral's registers: one struct per register with encode
// and decode.
#include <fmt/format.h>

#include <cctype>

#include "register_generator/description.hpp"
#include "register_generator/template.hpp"

namespace register_generator {
namespace {

constexpr std::string_view header_template =
    R"(// SPDX-License-Identifier: Apache-2.0
// Registers of `@unit@`. Generated from @source@: do not edit.
// clang-format off
#pragma once

#include <cstddef>
#include <cstdint>

// @summary@
namespace registers::@unit@ {

inline constexpr std::uint32_t base = 0x@address@u;
@constants@
@registers@

}  // namespace registers::@unit@
)";

constexpr std::string_view register_template = R"(
// @summary@
struct @type@ {
  @address@
  @places@
  @enumerations@
  @fields@

  [[gnu::always_inline]] static constexpr @type@ decode([[maybe_unused]] std::uint32_t word) {
    return {
      @decoded@
    };
  }
  constexpr std::uint32_t encode() const {
    return @encoded@;
  }
};
)";

constexpr std::string_view one_address =
    R"(static constexpr std::uint32_t address = base + 0x@offset@u;
)";

constexpr std::string_view array_addresses =
    R"(static constexpr std::size_t count = @count@;
static constexpr std::uint32_t address_of(std::size_t index) {
  return base + 0x@offset@u + 4u * static_cast<std::uint32_t>(index);
}
)";

constexpr std::string_view number_places =
    R"(static constexpr unsigned @field@_low = @low@, @field@_width = @width@;
static constexpr std::uint32_t @field@_max = 0x@max@u, @field@_mask = @field@_max << @field@_low;
)";

constexpr std::string_view bit_places =
    R"(static constexpr unsigned @field@_bit = @low@;
static constexpr std::uint32_t @field@_mask = 1u << @field@_bit;
)";

constexpr std::string_view enumeration_template =
    R"(enum class @type@ : std::uint@bits@_t {
  @values@
};
)";

constexpr std::string_view wide_template = R"(
// @summary@ Two words.
struct @type@ {
  using Low = @type@Low;
  using High = @type@High;
  @number@ @field@{};

  [[gnu::always_inline]] static constexpr @type@ decode(Low low, High high) {
    return {.@field@ = static_cast<@number@>(std::uint64_t{high.@field@} << 32 | low.@field@)};
  }
  constexpr Low low() const { return {.@field@ = static_cast<std::uint32_t>(@field@)}; }
  constexpr High high() const {
    return {.@field@ = static_cast<std::uint32_t>(static_cast<std::uint64_t>(@field@) >> 32)};
  }
};
)";

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
  if (field.is_enumeration()) return pascal_case(field.name);
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
  if (field.is_enumeration()) return fmt::format("static_cast<{}>({})", type_of(field), masked);
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
                      : field.type == FieldType::signed_number || field.is_enumeration()
                          ? fmt::format("static_cast<std::uint32_t>({})", field.name)
                          : field.name;
  if (field.width() < 32 && field.type != FieldType::bit) {
    value = fmt::format("({} & 0x{:X}u)", value, field.mask());
  }
  return field.lsb == 0 ? value : fmt::format("{} << {}u", value, field.lsb);
}

std::string places(const Field& field) {
  return fill(field.type == FieldType::bit ? bit_places : number_places,
              {{"field", field.name},
               {"low", std::to_string(field.lsb)},
               {"width", std::to_string(field.width())},
               {"max", fmt::format("{:X}", field.mask())}});
}

std::string enumeration(const Field& field) {
  std::string values;
  for (const auto& [name, value] : field.values) values += fmt::format("{} = {},\n", name, value);
  const unsigned bits = field.width() <= 8 ? 8 : field.width() <= 16 ? 16 : 32;
  return fill(enumeration_template,
              {{"type", type_of(field)}, {"bits", std::to_string(bits)}, {"values", values}});
}

std::string register_text(const Register& r) {
  std::string all_places, enumerations, fields, decodings, encodings;
  for (const Field& field : r.fields) {
    all_places += places(field);
    if (field.is_enumeration()) enumerations += enumeration(field);
    fields += fmt::format("// {}\n{} {}{{}};\n", field.summary, type_of(field), field.name);
    decodings += fmt::format(".{} = {},\n", field.name, decoded(field));
    encodings += (encodings.empty() ? "" : " |\n           ") + encoded(field);
  }
  return fill(register_template, {{"summary", r.summary},
                                  {"type", pascal_case(r.name)},
                                  {"address", fill(r.is_array ? array_addresses : one_address,
                                                   {{"count", std::to_string(r.count)},
                                                    {"offset", fmt::format("{:X}", r.offset)}})},
                                  {"places", all_places},
                                  {"enumerations", enumerations},
                                  {"fields", fields},
                                  {"decoded", decodings},
                                  {"encoded", encodings}});
}

std::string wide_text(const WideRegister& wide) {
  return fill(wide_template, {{"summary", wide.summary},
                              {"type", pascal_case(wide.name)},
                              {"number", wide.is_signed ? "std::int64_t" : "std::uint64_t"},
                              {"field", wide.field}});
}

}  // namespace

std::string cpp_file(const Peripheral& peripheral, const std::string& source) {
  std::string constants, registers;
  for (const Constant& constant : peripheral.constants) {
    constants += fmt::format("\n// {}\ninline constexpr std::uint32_t {} = {};\n", constant.summary,
                             constant.name, constant.value);
  }
  for (const Register& r : peripheral.registers) registers += register_text(r);
  for (const WideRegister& wide : peripheral.wide_registers) registers += wide_text(wide);
  return fill(header_template, {{"unit", peripheral.name},
                                {"source", source},
                                {"summary", peripheral.summary},
                                {"address", fmt::format("{:08X}", peripheral.address)},
                                {"constants", constants},
                                {"registers", registers}});
}

}  // namespace register_generator
