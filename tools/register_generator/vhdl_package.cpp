// SPDX-License-Identifier: Apache-2.0
// Writes the VHDL package of a peripheral's registers: their types, and the records between
// hardware and software.
#include "register_generator/vhdl_writer.hpp"

namespace register_generator {
namespace {

class VhdlPackageWriter : private VhdlWriter {
 public:
  VhdlPackageWriter(const Peripheral& peripheral, const std::string& source)
      : VhdlWriter(peripheral, "Types of the registers", source) {}

  std::string write() {
    package();
    return text_;
  }

 private:
  std::string type_of(const Field& field) const {
    switch (field.type) {
      case FieldType::bit:
        return "std_ulogic";
      case FieldType::unsigned_number:
        return fmt::format("unsigned({} downto 0)", field.width() - 1);
      case FieldType::signed_number:
        return fmt::format("signed({} downto 0)", field.width() - 1);
      case FieldType::bits:
        return fmt::format("std_ulogic_vector({} downto 0)", field.width() - 1);
    }
    return {};
  }

  void package() {
    heading();
    line("package {}_registers_pkg is", peripheral_.name);
    line("");
    line("  constant {}_address : unsigned(31 downto 0) := x\"{:08X}\";", peripheral_.name,
         peripheral_.address);
    for (const Register& r : peripheral_.registers) {
      line("");
      line("  -- {}", r.summary);
      line("  constant {}_{}_address : unsigned(31 downto 0) := x\"{:08X}\";{}", peripheral_.name,
           r.name, peripheral_.address + r.offset, r.is_array ? "  -- of the first" : "");
      line("  type {} is record", record_of(r));
      for (const Field& field : r.fields) line("    {} : {};", field.name, type_of(field));
      line("  end record;");
      if (r.is_array) {
        line("  type {} is array (0 to {}) of {};", value_type(r), r.count - 1, record_of(r));
      }
      for (const Field& field : r.fields) {
        for (const auto& [name, value] : field.values) {
          line("  constant {}_{}_{}_{} : natural := {};", peripheral_.name, r.name, field.name,
               name, value);
        }
      }
    }
    direction_records();
    line("");
    line("end package;");
  }

  void direction_records() {
    if (peripheral_.has_from_software()) {
      line("");
      line("  type {}_from_software_t is record", peripheral_.name);
      for (const Register& r : peripheral_.registers) {
        if (r.writable()) line("    {} : {};", r.name, value_type(r));
        if (r.has_written()) line("    {}_written : {};", r.name, event_type(r));
        if (r.read_event) line("    {}_read : {};", r.name, event_type(r));
      }
      line("  end record;");
    }
    if (peripheral_.has_to_software()) {
      line("");
      line("  type {}_to_software_t is record", peripheral_.name);
      for (const Register& r : peripheral_.registers) {
        if (r.value_to_software()) line("    {} : {};", r.name, value_type(r));
      }
      line("  end record;");
    }
  }
};

}  // namespace

std::string vhdl_package(const Peripheral& peripheral, const std::string& source) {
  return VhdlPackageWriter(peripheral, source).write();
}

}  // namespace register_generator
