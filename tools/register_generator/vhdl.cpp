// SPDX-License-Identifier: Apache-2.0
// Writes the VHDL of a peripheral's registers: a package of records and the bus slave that holds them.
#include <fmt/format.h>

#include "register_generator/description.hpp"

namespace register_generator {
namespace {

class VhdlWriter {
 public:
  VhdlWriter(const Peripheral& peripheral, const std::string& source)
      : peripheral_(peripheral), source_(source) {}

  std::string write() {
    package();
    entity();
    return text_;
  }

 private:
  template <class... Arguments>
  void line(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    text_ += fmt::format(format, std::forward<Arguments>(arguments)...);
    text_ += '\n';
  }

  std::string type_of(const Field& field) const {
    switch (field.type) {
      case FieldType::bit: return "std_ulogic";
      case FieldType::unsigned_number: return fmt::format("unsigned({} downto 0)", field.width() - 1);
      case FieldType::signed_number: return fmt::format("signed({} downto 0)", field.width() - 1);
      case FieldType::bits: return fmt::format("std_ulogic_vector({} downto 0)", field.width() - 1);
    }
    return {};
  }

  std::string record_of(const Register& r) const {
    return fmt::format("{}_{}_t", peripheral_.name, r.name);
  }
  std::string value_type(const Register& r) const {
    return r.is_array ? fmt::format("{}_{}_array_t", peripheral_.name, r.name) : record_of(r);
  }
  std::string event_type(const Register& r) const {
    return r.is_array ? fmt::format("std_ulogic_vector(0 to {})", r.count - 1) : "std_ulogic";
  }
  std::string element(const Register& r, unsigned index) const {
    return r.is_array ? fmt::format("({})", index) : "";
  }

  void libraries() {
    line("library ieee;");
    line("use ieee.std_logic_1164.all;");
    line("use ieee.numeric_std.all;");
    line("");
  }

  void package() {
    line("-- SPDX-License-Identifier: Apache-2.0");
    line("-- Registers of `{}`. Generated from {}: do not edit.", peripheral_.name, source_);
    line("");
    libraries();
    line("package {}_registers_pkg is", peripheral_.name);
    line("");
    line("  constant {}_address : unsigned(31 downto 0) := x\"{:08X}\";", peripheral_.name,
         peripheral_.address);
    for (const Register& r : peripheral_.registers) {
      line("");
      line("  -- {}", r.summary);
      line("  type {} is record", record_of(r));
      for (const Field& field : r.fields) line("    {} : {};", field.name, type_of(field));
      line("  end record;");
      if (r.is_array) {
        line("  type {} is array (0 to {}) of {};", value_type(r), r.count - 1, record_of(r));
      }
      for (const Field& field : r.fields) {
        for (const auto& [name, value] : field.values) {
          line("  constant {}_{}_{}_{} : natural := {};", peripheral_.name, r.name, field.name, name,
               value);
        }
      }
    }
    direction_records();
    line("");
    line("end package;");
    line("");
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

  void entity() {
    libraries();
    line("use work.bus_pkg.all;");
    line("use work.{}_registers_pkg.all;", peripheral_.name);
    line("");
    line("entity {}_registers is", peripheral_.name);
    line("  port (");
    line("    clk : in std_ulogic;");
    line("    reset : in std_ulogic;");
    line("    request : in bus_request_t;");
    const bool from = peripheral_.has_from_software();
    const bool to = peripheral_.has_to_software();
    line("    response : out bus_response_t := bus_response_idle{}", from || to ? ";" : "");
    if (from) {
      line("    from_software : out {}_from_software_t{}", peripheral_.name, to ? ";" : "");
    }
    if (to) line("    to_software : in {}_to_software_t", peripheral_.name);
    line("  );");
    line("end entity;");
    line("");
    architecture();
  }

  void architecture() {
    line("architecture rtl of {}_registers is", peripheral_.name);
    line("");
    line("  signal answered : std_ulogic := '0';");
    if (writes_pass_by()) {
      line("  signal written_data : std_ulogic_vector(31 downto 0) := (others => '0');");
    }
    for (const Register& r : peripheral_.registers) {
      if (!r.stored()) continue;
      for (unsigned index = 0; index < r.count; ++index) {
        line("  signal {} : std_ulogic_vector(31 downto 0) := x\"{:08X}\";", storage(r, index),
             reset_word(r));
      }
    }
    line("");
    line("begin");
    line("");
    access_process();
    for (const Register& r : peripheral_.registers) {
      if (r.writable()) connect_values(r);
    }
    line("end architecture;");
  }

  bool writes_pass_by() const {
    for (const Register& r : peripheral_.registers) {
      if (r.writable() && !r.stored()) return true;
    }
    return false;
  }

  static std::uint32_t reset_word(const Register& r) {
    std::uint32_t word = 0;
    for (const Field& field : r.fields) word |= field.reset << field.lsb;
    return word;
  }

  std::string storage(const Register& r, unsigned index) const {
    return r.is_array ? fmt::format("{}_{}_stored", r.name, index) : r.name + "_stored";
  }

  void clear_events(const char* indent) {
    for (const Register& r : peripheral_.registers) {
      const std::string idle = r.is_array ? "(others => '0')" : "'0'";
      if (r.has_written()) line("{}from_software.{}_written <= {};", indent, r.name, idle);
      if (r.read_event) line("{}from_software.{}_read <= {};", indent, r.name, idle);
    }
  }

  void access_process() {
    line("  -- Answers in the clock after the strobe: whole words only, errors for everything not described.");
    line("  answer : process");
    line("    variable word : std_ulogic_vector(31 downto 0);");
    line("    variable known : boolean;");
    line("  begin");
    line("    wait until rising_edge(clk);");
    line("    if answered then");
    line("      response <= bus_response_idle;");
    line("      answered <= '0';");
    clear_events("      ");
    line("    elsif request.strobe then");
    line("      word := (others => '0');");
    line("      known := false;");
    line("      answered <= '1';");
    if (writes_pass_by()) line("      written_data <= request.data;");
    line("      case to_integer(request.address(11 downto 2)) is");
    for (const Register& r : peripheral_.registers) {
      for (unsigned index = 0; index < r.count; ++index) one_register(r, index);
    }
    line("        when others =>");
    line("          null;");
    line("      end case;");
    line("      if known then");
    line("        response.acknowledge <= '1';");
    line("        response.data <= word;");
    line("      else");
    line("        response.error <= '1';");
    line("      end if;");
    line("    end if;");
    line("    if reset then");
    line("      response <= bus_response_idle;");
    line("      answered <= '0';");
    clear_events("      ");
    for (const Register& r : peripheral_.registers) {
      if (!r.stored()) continue;
      for (unsigned index = 0; index < r.count; ++index) {
        line("      {} <= x\"{:08X}\";", storage(r, index), reset_word(r));
      }
    }
    line("    end if;");
    line("  end process;");
    line("");
  }

  void one_register(const Register& r, unsigned index) {
    line("        when {} =>", r.offset / 4 + index);
    const std::string at = element(r, index);
    if (r.readable()) {
      line("          if not request.write then");
      line("            known := true;");
      for (const Field& field : r.fields) read_field(r, field, index);
      if (r.read_event) line("            from_software.{}_read{} <= '1';", r.name, at);
      line("          end if;");
    }
    if (r.writable()) {
      line("          if request.write and (and request.select_bytes) then");
      line("            known := true;");
      if (r.stored()) {
        for (const Field& field : r.fields) {
          line("            {}({} downto {}) <= request.data({} downto {});", storage(r, index),
               field.msb, field.lsb, field.msb, field.lsb);
        }
      }
      if (r.has_written()) line("            from_software.{}_written{} <= '1';", r.name, at);
      line("          end if;");
    }
  }

  void read_field(const Register& r, const Field& field, unsigned index) {
    if (r.stored()) {
      line("            word({} downto {}) := {}({} downto {});", field.msb, field.lsb,
           storage(r, index), field.msb, field.lsb);
      return;
    }
    const std::string value =
        fmt::format("to_software.{}{}.{}", r.name, element(r, index), field.name);
    switch (field.type) {
      case FieldType::bit: line("            word({}) := {};", field.lsb, value); break;
      case FieldType::bits:
        line("            word({} downto {}) := {};", field.msb, field.lsb, value);
        break;
      default:
        line("            word({} downto {}) := std_ulogic_vector({});", field.msb, field.lsb, value);
    }
  }

  void connect_values(const Register& r) {
    for (unsigned index = 0; index < r.count; ++index) {
      const std::string word = r.stored() ? storage(r, index) : "written_data";
      for (const Field& field : r.fields) {
        const std::string target =
            fmt::format("from_software.{}{}.{}", r.name, element(r, index), field.name);
        const std::string slice = fmt::format("{}({} downto {})", word, field.msb, field.lsb);
        switch (field.type) {
          case FieldType::bit: line("  {} <= {}({});", target, word, field.lsb); break;
          case FieldType::unsigned_number: line("  {} <= unsigned({});", target, slice); break;
          case FieldType::signed_number: line("  {} <= signed({});", target, slice); break;
          case FieldType::bits: line("  {} <= {};", target, slice); break;
        }
      }
    }
    line("");
  }

  const Peripheral& peripheral_;
  std::string source_;
  std::string text_;
};

}  // namespace

std::string vhdl_file(const Peripheral& peripheral, const std::string& source) {
  return VhdlWriter(peripheral, source).write();
}

}  // namespace register_generator
