// SPDX-License-Identifier: Apache-2.0
// Writes the VHDL entity of a peripheral's registers: the bus slave that holds them.
#include <algorithm>
#include <bit>
#include <string_view>
#include <vector>

#include "register_generator/vhdl_writer.hpp"

namespace register_generator {
namespace {

class VhdlRegistersWriter : private VhdlWriter {
 public:
  VhdlRegistersWriter(const Peripheral& peripheral, const std::string& source)
      : VhdlWriter(peripheral, "Registers", source) {}

  std::string write() {
    entity();
    return text_;
  }

 private:
  std::string element(const Register& r, unsigned index) const {
    return r.is_array ? fmt::format("({})", index) : "";
  }

  void entity() {
    heading();
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
    line("  -- The first clock of an access, and what it was, one clock later.");
    line("  signal access_begins : std_ulogic;");
    line("  signal answered, writing : std_ulogic := '0';");
    line("  -- Of what is known only: the bits above are 0.");
    line("  signal register_index : unsigned({} downto 0) := (others => '0');",
         highest_index_bit());
    line("  signal written_data : std_ulogic_vector(31 downto 0) := (others => '0');");
    line("  signal readable, writable, known : std_ulogic;");
    line("  signal read_word : std_ulogic_vector(31 downto 0);");
    for_each_register([&](const Register& r, unsigned index) {
      if (r.readable()) line("  signal {} : std_ulogic_vector(31 downto 0);", word(r, index));
      if (r.stored()) {
        line("  signal {} : std_ulogic_vector(31 downto 0) := x\"{:08X}\";", storage(r, index),
             reset_word(r));
      }
    });
    for_each_event([&](const std::string& event, bool, unsigned) {
      line("  signal {} : std_ulogic := '0';", event);
    });
    line("");
    line("begin");
    line("");
    answer_process();
    known_registers();
    readable_words();
    store_process();
    event_process();
    for (const Register& r : peripheral_.registers) connect(r);
    line("end architecture;");
  }

  template <class Action>
  void for_each_register(Action action) {
    for (const Register& r : peripheral_.registers) {
      for (unsigned index = 0; index < r.count; ++index) action(r, index);
    }
  }

  // Writes and reads that the hardware sees in the clock of their acknowledge.
  template <class Action>
  void for_each_event(Action action) {
    for_each_register([&](const Register& r, unsigned index) {
      const unsigned number = r.offset / 4 + index;
      if (r.has_written() && !r.stored()) action(name_of(r, index) + "_written", true, number);
      if (r.read_event) action(name_of(r, index) + "_read", false, number);
    });
  }

  static std::uint32_t reset_word(const Register& r) {
    std::uint32_t word = 0;
    for (const Field& field : r.fields) word |= field.reset << field.lsb;
    return word;
  }

  static std::string name_of(const Register& r, unsigned index) {
    return r.is_array ? fmt::format("{}_{}", r.name, index) : r.name;
  }
  static std::string storage(const Register& r, unsigned index) {
    return name_of(r, index) + "_stored";
  }
  static std::string word(const Register& r, unsigned index) { return name_of(r, index) + "_word"; }

  // The registers that `kind` holds for, as ranges of word offsets.
  template <class Kind>
  std::vector<std::pair<unsigned, unsigned>> ranges(Kind kind) const {
    std::vector<std::pair<unsigned, unsigned>> found;
    for (const Register& r : peripheral_.registers) {
      if (!kind(r)) continue;
      const unsigned first = r.offset / 4;
      if (!found.empty() && found.back().second + 1 == first) {
        found.back().second = first + r.count - 1;
      } else {
        found.emplace_back(first, first + r.count - 1);
      }
    }
    return found;
  }

  // Of the index of the last register.
  unsigned highest_index_bit() const {
    unsigned last = 1;
    for (const Register& r : peripheral_.registers)
      last = std::max(last, r.offset / 4 + r.count - 1);
    return static_cast<unsigned>(std::bit_width(last)) - 1;
  }

  void decode(const char* signal, const std::vector<std::pair<unsigned, unsigned>>& found) {
    if (found.empty()) {
      line("  {} <= '0';", signal);
      return;
    }
    for (std::size_t i = 0; i < found.size(); ++i) {
      const auto [first, last] = found[i];
      const std::string range =
          first == last ? fmt::format("request.address(11 downto 2) = {}", first)
          : first == 0  ? fmt::format("request.address(11 downto 2) <= {}", last)
                        : fmt::format(
                             "(request.address(11 downto 2) >= {} and "
                              "request.address(11 downto 2) <= {})",
                             first, last);
      line("  {}{}{}", i == 0 ? fmt::format("{} <= '1' when ", signal) : "    or ", range,
           i + 1 == found.size() ? " else '0';" : "");
    }
  }

  void answer_process() {
    line("  access_begins <= request.strobe and not answered;");
    line("");
    line(
        "  -- Answers in the clock after the strobe; an error for everything that is not "
        "described.");
    line("  answer : process");
    line("  begin");
    line("    wait until rising_edge(clk);");
    line("    answered <= access_begins;");
    line("    writing <= access_begins and known and request.write;");
    line("    response.acknowledge <= access_begins and known;");
    line("    response.error <= access_begins and not known;");
    line("    response.data <= (others => '0');");
    line("    if access_begins then");
    line("      response.data <= read_word;");
    line("      written_data <= request.data;");
    line("      register_index <= request.address({} downto 2);", highest_index_bit() + 2);
    line("    end if;");
    line("    if reset then");
    line("      answered <= '0';");
    line("      writing <= '0';");
    line("      response <= bus_response_idle;");
    line("    end if;");
    line("  end process;");
    line("");
  }

  void known_registers() {
    line("  -- Whole words only.");
    line(
        "  known <= writable and (and request.select_bytes) when request.write = '1' else "
        "readable;");
    line("");
    decode("readable", ranges([](const Register& r) { return r.readable(); }));
    line("");
    decode("writable", ranges([](const Register& r) { return r.writable(); }));
    line("");
  }

  void readable_words() {
    std::string all;
    for_each_register([&](const Register& r, unsigned index) {
      if (!r.readable()) return;
      all += fmt::format("{}{}", all.empty() ? "" : "\n    or ", word(r, index));
      const std::string target = word(r, index);
      unsigned above = 32;
      std::string value;
      std::vector<Field> fields = r.fields;
      std::ranges::sort(fields, {}, [](const Field& f) { return 32 - f.msb; });
      for (const Field& field : fields) {
        if (above > field.msb + 1) value += zeros(above - field.msb - 1) + " & ";
        value += read_field(r, field, index) + " & ";
        above = field.lsb;
      }
      if (above > 0) value += zeros(above) + " & ";
      value.resize(value.size() - 3);
      line("  {} <= {}", target, value);
      line("    when request.address(11 downto 2) = {} else (others => '0');",
           r.offset / 4 + index);
    });
    line("");
    line("  read_word <= {};", all.empty() ? "(others => '0')" : all);
    line("");
  }

  static std::string zeros(unsigned count) {
    return count == 1 ? "'0'" : "\"" + std::string(count, '0') + "\"";
  }

  std::string read_field(const Register& r, const Field& field, unsigned index) const {
    if (r.stored()) return slice(storage(r, index), field);
    const std::string value =
        fmt::format("to_software.{}{}.{}", r.name, element(r, index), field.name);
    if (field.type == FieldType::bit || field.type == FieldType::bits) return value;
    return fmt::format("std_ulogic_vector({})", value);
  }

  static std::string slice(const std::string& word, const Field& field) {
    return field.type == FieldType::bit
               ? fmt::format("{}({})", word, field.lsb)
               : fmt::format("{}({} downto {})", word, field.msb, field.lsb);
  }

  void store_process() {
    bool some = false;
    for (const Register& r : peripheral_.registers) some |= r.stored();
    if (!some) return;
    line("  store : process");
    line("  begin");
    line("    wait until rising_edge(clk);");
    for_each_register([&](const Register& r, unsigned index) {
      if (!r.stored()) return;
      line("    if writing = '1' and register_index = {} then", r.offset / 4 + index);
      line("      {} <= written_data;", storage(r, index));
      line("    end if;");
    });
    line("    if reset then");
    for_each_register([&](const Register& r, unsigned index) {
      if (r.stored()) line("      {} <= x\"{:08X}\";", storage(r, index), reset_word(r));
    });
    line("    end if;");
    line("  end process;");
    line("");
  }

  // Which register it is, is found out before the clock in which the hardware needs it.
  void event_process() {
    bool some = false;
    for_each_event([&](const std::string&, bool, unsigned) { some = true; });
    if (!some) return;
    line("  tell_events : process");
    line("  begin");
    line("    wait until rising_edge(clk);");
    for_each_event([&](const std::string& event, bool write, unsigned number) {
      line("    {} <= access_begins and known and {}request.write and", event, write ? "" : "not ");
      line("      (request.address(11 downto 2) ?= {});", number);
    });
    line("    if reset then");
    for_each_event(
        [&](const std::string& event, bool, unsigned) { line("      {} <= '0';", event); });
    line("    end if;");
    line("  end process;");
    line("");
  }

  void connect(const Register& r) {
    for (unsigned index = 0; index < r.count; ++index) {
      const std::string at = element(r, index);
      const unsigned number = r.offset / 4 + index;
      if (r.has_written() && r.stored()) note_stored(r, at, number);
      if (r.has_written() && !r.stored()) {
        line("  from_software.{0}_written{1} <= {2}_written;", r.name, at, name_of(r, index));
      }
      if (r.read_event) {
        line("  from_software.{0}_read{1} <= {2}_read;", r.name, at, name_of(r, index));
      }
      if (!r.writable()) continue;
      const std::string source = r.stored() ? storage(r, index) : "written_data";
      for (const Field& field : r.fields) {
        const std::string bits = slice(source, field);
        const char* conversion = field.type == FieldType::unsigned_number ? "unsigned"
                                 : field.type == FieldType::signed_number ? "signed"
                                                                          : "";
        line("  from_software.{}{}.{} <= {}{};", r.name, at, field.name, conversion,
             *conversion ? "(" + bits + ")" : bits);
      }
    }
  }

  // One clock later than the write, together with the stored value.
  void note_stored(const Register& r, const std::string& at, unsigned number) {
    line("  note_{}{} : process", r.name, at.empty() ? "" : "_" + at.substr(1, at.size() - 2));
    line("  begin");
    line("    wait until rising_edge(clk);");
    line(
        "    from_software.{}_written{} <= '1' when writing = '1' and register_index = {} else "
        "'0';",
        r.name, at, number);
    line("  end process;");
    line("");
  }
};

}  // namespace

std::string vhdl_registers(const Peripheral& peripheral, const std::string& source) {
  return VhdlRegistersWriter(peripheral, source).write();
}

}  // namespace register_generator
