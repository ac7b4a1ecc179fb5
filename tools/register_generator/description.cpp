// SPDX-License-Identifier: Apache-2.0
// Reads a register description (TOML) and refuses everything that the generators do not support.
#include "register_generator/description.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <set>

#include "register_generator/description_reader.hpp"

namespace register_generator {
namespace {

constexpr unsigned window_bytes = 4096;

constexpr std::string_view wide_bits = "63:0";

bool is_wide(const toml::table& table) {
  return table["field"][0]["bits"].value_or<std::string>("") == wide_bits;
}

// One half of a wide register, described as a register of its own.
toml::table half_of(const toml::table& wide, const std::string& half) {
  const bool low = half == "low";
  toml::table result = wide;
  toml::table& field = *result["field"][0].as_table();
  const auto text = [](const toml::table& table, const char* key) {
    return table[key].value_or<std::string>("");
  };
  result.insert_or_assign("name", text(wide, "name") + "_" + half);
  result.insert_or_assign("summary", (low ? "Low word: " : "High word: ") + text(wide, "summary"));
  if (const auto* access = wide["access_" + half].as_string()) {
    result.insert_or_assign("access", *access);
  }
  result.erase("access_low");
  result.erase("access_high");
  if (!low) result.erase("read_event");
  if (text(result, "access") != "read_write") field.erase("reset");
  field.insert_or_assign("bits", "31:0");
  field.insert_or_assign("type", "unsigned");
  field.insert_or_assign("summary",
                         text(field, "summary") + (low ? " Bits 31:0." : " Bits 63:32."));
  return result;
}

WideRegister read_wide(const Reader& reader, const toml::table& table) {
  WideRegister result;
  result.name = reader.name(table, "a register");
  result.summary = reader.summary(table, result.name);
  const auto* fields = table["field"].as_array();
  const auto* field = fields->size() == 1 ? fields->front().as_table() : nullptr;
  if (!field) reader.fail(result.name, "64 bits are one field alone");
  if (table.contains("count")) reader.fail(result.name, "64 bits are no array");
  result.field = reader.name(*field, result.name);
  result.is_signed = (*field)["type"].value_or<std::string>("unsigned") == "signed";
  return result;
}

Register read_register(const Reader& reader, const toml::table& table, unsigned& next_offset) {
  Register result;
  result.name = reader.name(table, "a register");
  const std::string place = result.name;
  reader.only_keys(
      table, place,
      {"name", "access", "summary", "offset", "count", "read_event", "write_event", "field"});
  result.summary = reader.summary(table, place);
  result.access = reader.access(table, place);
  result.is_array = table.contains("count");
  result.count = reader.number(table, "count", place, 1, window_bytes / 4);
  if (result.count == 0) reader.fail(place, "'count' must be at least 1");
  result.offset = reader.number(table, "offset", place, next_offset, window_bytes - 4);
  if (result.offset % 4 != 0) reader.fail(place, "'offset' must be a multiple of 4");
  if (result.offset < next_offset) reader.fail(place, "'offset' overlaps the register before");
  next_offset = result.offset + 4 * result.count;
  if (next_offset > window_bytes) reader.fail(place, "lies beyond the 4 KiB of a peripheral");
  result.read_event = reader.flag(table, "read_event", place);
  result.write_event = reader.flag(table, "write_event", place);
  if (result.read_event && !result.readable()) {
    reader.fail(place, "read_event on a write-only register");
  }
  if (result.write_event && !result.writable()) {
    reader.fail(place, "write_event on a read-only register");
  }

  const auto* fields = table["field"].as_array();
  if (!fields || fields->empty()) reader.fail(place, "needs at least one field");
  std::uint32_t used = 0;
  for (const auto& node : *fields) {
    const auto* field_table = node.as_table();
    if (!field_table) reader.fail(place, "'field' must be [[register.field]]");
    const Field field = reader.field(*field_table, place);
    const std::uint32_t bits = field.mask() << field.lsb;
    if ((used & bits) != 0) reader.fail(place, "field '" + field.name + "' overlaps another");
    if (field.reset != 0 && !result.stored()) {
      reader.fail(place, "field '" + field.name + "' has a reset value but is not read_write");
    }
    used |= bits;
    result.fields.push_back(field);
  }
  return result;
}

// Adds registers to a peripheral, each after the one before.
class RegisterList {
 public:
  explicit RegisterList(Peripheral& peripheral) : peripheral_(peripheral) {}

  // All registers of one file.
  void add_all(const Reader& reader, const toml::table& table) {
    const auto* registers = table["register"].as_array();
    if (!registers || registers->empty()) {
      reader.fail("top level", "needs at least one [[register]]");
    }
    for (const auto& node : *registers) {
      const auto* described = node.as_table();
      if (!described) reader.fail("top level", "'register' must be [[register]]");
      if (is_wide(*described)) {
        peripheral_.wide_registers.push_back(read_wide(reader, *described));
        add(reader, half_of(*described, "low"));
        add(reader, half_of(*described, "high"));
      } else {
        add(reader, *described);
      }
    }
  }

 private:
  void add(const Reader& reader, const toml::table& described) {
    peripheral_.registers.push_back(read_register(reader, described, next_offset_));
    const std::string& name = peripheral_.registers.back().name;
    if (!names_.insert(name).second) reader.fail(name, "is described twice");
  }

  Peripheral& peripheral_;
  unsigned next_offset_ = 0;
  std::set<std::string> names_;
};

}  // namespace

bool Peripheral::has_from_software() const {
  return std::ranges::any_of(registers,
                             [](const Register& r) { return r.writable() || r.read_event; });
}

bool Peripheral::has_to_software() const {
  return std::ranges::any_of(registers, &Register::value_to_software);
}

Peripheral load(const std::filesystem::path& file) {
  const Reader reader(file);
  const toml::table table = reader.table();
  reader.only_keys(table, "top level",
                   {"name", "address", "summary", "include", "constant", "interrupt", "register"});
  Peripheral peripheral;
  peripheral.name = reader.name(table, "top level");
  peripheral.summary = reader.summary(table, "top level");
  peripheral.address = reader.number(table, "address", "top level", 1, 0xFFFF'F000u);
  if (peripheral.address % window_bytes != 0) reader.fail("address", "must be a multiple of 4096");
  RegisterList list(peripheral);
  list.add_all(reader, table);
  for (const std::filesystem::path& included : reader.includes(table)) {
    const Reader part(included);
    const toml::table registers = part.table();
    part.only_keys(registers, "top level", {"register"});
    list.add_all(part, registers);
  }
  peripheral.constants =
      reader.numbers<Constant>(table, "constant", "value", std::numeric_limits<int>::max());
  peripheral.interrupts = reader.numbers<Interrupt>(table, "interrupt", "number", 31);
  for (Interrupt& interrupt : peripheral.interrupts) interrupt.peripheral = peripheral.name;
  return peripheral;
}

std::vector<std::filesystem::path> description_files(const std::filesystem::path& folder) {
  std::set<std::filesystem::path> files, included;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".toml") continue;
    const Reader reader(entry.path());
    files.insert(entry.path());
    for (const std::filesystem::path& part : reader.includes(reader.table())) included.insert(part);
  }
  std::vector<std::filesystem::path> found;
  std::ranges::set_difference(files, included, std::back_inserter(found));
  return found;
}

}  // namespace register_generator
