// SPDX-License-Identifier: Apache-2.0
// Writes the VHDL package of a peripheral's registers: types, places of fields, words from values
// and back, and the records between hardware and software.
#include <algorithm>
#include <string_view>

#include "register_generator/template.hpp"
#include "register_generator/vhdl_names.hpp"

namespace register_generator {
namespace {

constexpr std::string_view package_template =
    R"(-- SPDX-License-Identifier: Apache-2.0
-- Types of the registers of `@unit@`. Generated from @source@: do not edit.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

package @unit@_registers_pkg is

  constant @unit@_address : unsigned(31 downto 0) := x"@address@";
  @constants@
  @registers@
  @directions@

end package;

package body @unit@_registers_pkg is
  @bodies@

end package body;
)";

constexpr std::string_view register_template = R"(
-- @summary@
constant @register@_address : unsigned(31 downto 0) := x"@address@";@first@
@places@
type @register@_t is record
  @fields@
end record;
@array@
@after_reset@
@values@
function to_word(value : @register@_t) return std_ulogic_vector;
function to_@register@(word : std_ulogic_vector(31 downto 0)) return @register@_t;
)";

constexpr std::string_view functions_template = R"(
function to_word(value : @register@_t) return std_ulogic_vector is
begin
  return @word@;
end function;

function to_@register@(word : std_ulogic_vector(31 downto 0)) return @register@_t is
begin
  return (
    @associations@);
end function;
)";

constexpr std::string_view record_template = R"(
type @unit@_@direction@_t is record
  @elements@
end record;
)";

std::string type_of(const Field& field) {
  const char* type = field.type == FieldType::unsigned_number ? "unsigned"
                     : field.type == FieldType::signed_number ? "signed"
                                                              : "std_ulogic_vector";
  if (field.type == FieldType::bit) return "std_ulogic";
  return fmt::format("{}({} downto 0)", type, field.width() - 1);
}

std::string zeros(unsigned count) {
  return count == 1 ? "'0'" : "\"" + std::string(count, '0') + "\"";
}

class Writer {
 public:
  Writer(const Peripheral& peripheral, const std::string& source)
      : peripheral_(peripheral), source_(source) {}

  std::string write() const {
    std::string registers, bodies, constants;
    for (const Constant& constant : peripheral_.constants) {
      constants += fmt::format("\n-- {}\nconstant {}_{} : natural := {};\n", constant.summary,
                               peripheral_.name, constant.name, constant.value);
    }
    for (const Register& r : peripheral_.registers) {
      registers += declaration(r);
      bodies += functions(r);
    }
    return fill(package_template, {{"unit", peripheral_.name},
                                   {"source", source_},
                                   {"address", fmt::format("{:08X}", peripheral_.address)},
                                   {"constants", constants},
                                   {"registers", registers},
                                   {"directions", directions()},
                                   {"bodies", bodies}});
  }

 private:
  std::string prefix(const Register& r, const Field& field) const {
    return fmt::format("{}_{}", vhdl_register(peripheral_, r), field.name);
  }
  std::string place(const Register& r, const Field& field) const {
    return prefix(r, field) + (field.type == FieldType::bit ? "_bit" : "_bits");
  }

  std::string declaration(const Register& r) const {
    std::string places, fields, values;
    for (const Field& field : r.fields) {
      places += field.type == FieldType::bit
                    ? fmt::format("constant {} : natural := {};\n", place(r, field), field.lsb)
                    : fmt::format("subtype {} is natural range {} downto {};\n", place(r, field),
                                  field.msb, field.lsb);
      fields += fmt::format("{} : {};\n", field.name, type_of(field));
      for (const auto& [name, value] : field.values) {
        values += fmt::format("constant {}_{} : natural := {};\n", prefix(r, field), name, value);
      }
    }
    return fill(register_template,
                {{"summary", r.summary},
                 {"register", vhdl_register(peripheral_, r)},
                 {"address", fmt::format("{:08X}", peripheral_.address + r.offset)},
                 {"first", r.is_array ? "  -- of the first" : ""},
                 {"places", places},
                 {"fields", fields},
                 {"array", r.is_array ? fmt::format("type {} is array (0 to {}) of {};\n",
                                                    vhdl_type(peripheral_, r), r.count - 1,
                                                    vhdl_record(peripheral_, r))
                                      : ""},
                 {"after_reset", r.stored() ? after_reset(r) : ""},
                 {"values", values}});
  }

  std::string after_reset(const Register& r) const {
    std::string text;
    for (const Field& field : r.fields) {
      if (!text.empty()) text += ", ";
      text += field.type == FieldType::bit
                  ? fmt::format("{} => '{}'", field.name, field.reset)
                  : fmt::format("{} => {}x\"{:X}\"", field.name, field.width(), field.reset);
    }
    const std::string name = vhdl_register(peripheral_, r);
    return fmt::format("constant {0}_after_reset : {0}_t := ({1});\n", name, text);
  }

  std::string functions(const Register& r) const {
    std::string word, associations;
    unsigned above = 32;
    std::vector<Field> fields = r.fields;
    std::ranges::sort(fields, std::greater{}, &Field::msb);
    for (const Field& field : fields) {
      if (above > field.msb + 1) word += zeros(above - field.msb - 1) + " & ";
      const bool is_number =
          field.type == FieldType::unsigned_number || field.type == FieldType::signed_number;
      word += is_number ? fmt::format("std_ulogic_vector(value.{}) & ", field.name)
                        : fmt::format("value.{} & ", field.name);
      above = field.lsb;
    }
    if (above > 0) word += zeros(above) + " & ";
    word.resize(word.size() - 3);
    for (const Field& field : r.fields) {
      if (!associations.empty()) associations += ",\n";
      const std::string bits = fmt::format("word({})", place(r, field));
      associations += field.type == FieldType::unsigned_number
                          ? fmt::format("{} => unsigned({})", field.name, bits)
                      : field.type == FieldType::signed_number
                          ? fmt::format("{} => signed({})", field.name, bits)
                          : fmt::format("{} => {}", field.name, bits);
    }
    return fill(functions_template, {{"register", vhdl_register(peripheral_, r)},
                                     {"word", word},
                                     {"associations", associations}});
  }

  std::string directions() const {
    std::string from, to;
    for (const Register& r : peripheral_.registers) {
      const std::string event =
          r.is_array ? fmt::format("std_ulogic_vector(0 to {})", r.count - 1) : "std_ulogic";
      const std::string value = fmt::format("{} : {};\n", r.name, vhdl_type(peripheral_, r));
      if (r.writable()) from += value;
      if (r.has_written()) from += fmt::format("{}_written : {};\n", r.name, event);
      if (r.read_event) from += fmt::format("{}_read : {};\n", r.name, event);
      if (r.value_to_software()) to += value;
    }
    return direction("from_software", from) + direction("to_software", to);
  }

  std::string direction(const char* name, const std::string& elements) const {
    if (elements.empty()) return "";
    return fill(record_template,
                {{"unit", peripheral_.name}, {"direction", name}, {"elements", elements}});
  }

  const Peripheral& peripheral_;
  const std::string& source_;
};

}  // namespace

std::string vhdl_package(const Peripheral& peripheral, const std::string& source) {
  return Writer(peripheral, source).write();
}

}  // namespace register_generator
