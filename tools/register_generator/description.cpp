// SPDX-License-Identifier: Apache-2.0
// Reads a register description (TOML) and refuses everything that the generators could not honour.
#include "register_generator/description.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <limits>
#include <set>
#include <string_view>
#include <toml++/toml.hpp>

namespace register_generator {
namespace {

constexpr unsigned window_bytes = 4096;

class Reader {
 public:
  explicit Reader(const std::filesystem::path& file) : file_(file.string()) {}

  [[noreturn]] void fail(const std::string& place, const std::string& what) const {
    throw DescriptionError(fmt::format("{}: {}: {}", file_, place, what));
  }

  void only_keys(const toml::table& table, const std::string& place,
                 std::initializer_list<std::string_view> allowed) const {
    for (const auto& [key, node] : table) {
      if (std::ranges::find(allowed, key.str()) == allowed.end()) {
        fail(place, fmt::format("unknown key '{}'", key.str()));
      }
    }
  }

  std::string name(const toml::table& table, const std::string& place) const {
    const auto text = table["name"].value<std::string>();
    if (!text) fail(place, "needs a 'name'");
    const bool legal = !text->empty() && std::islower(static_cast<unsigned char>(text->front())) &&
                       std::ranges::all_of(*text, [](unsigned char c) {
                         return std::islower(c) || std::isdigit(c) || c == '_';
                       });
    if (!legal) fail(place, fmt::format("name '{}' is not lower snake_case", *text));
    return *text;
  }

  std::string summary(const toml::table& table, const std::string& place) const {
    const auto text = table["summary"].value<std::string>();
    if (!text || text->empty()) fail(place, "needs a 'summary'");
    return *text;
  }

  std::uint32_t number(const toml::table& table, const char* key, const std::string& place,
                       std::uint32_t otherwise, std::uint32_t limit) const {
    if (!table.contains(key)) return otherwise;
    const auto value = table[key].value<std::int64_t>();
    if (!value || *value < 0 || *value > limit) {
      fail(place, fmt::format("'{}' must be a whole number from 0 to {}", key, limit));
    }
    return static_cast<std::uint32_t>(*value);
  }

  bool flag(const toml::table& table, const char* key, const std::string& place) const {
    if (!table.contains(key)) return false;
    const auto value = table[key].value<bool>();
    if (!value) fail(place, fmt::format("'{}' must be true or false", key));
    return *value;
  }

  Access access(const toml::table& table, const std::string& place,
                const char* key = "access") const {
    const auto text = table[key].value_or<std::string>("");
    if (text == "read") return Access::read;
    if (text == "write") return Access::write;
    if (text == "read_write") return Access::read_write;
    if (text == "external") return Access::external;
    fail(place, fmt::format("'{}' must be read, write, read_write or external", key));
  }

  Field field(const toml::table& table, const std::string& register_place) const {
    Field field;
    field.name = name(table, register_place);
    const std::string place = register_place + "." + field.name;
    only_keys(table, place, {"name", "bits", "type", "reset", "values", "summary"});
    field.summary = summary(table, place);
    read_bits(table, place, field);
    read_type(table, place, field);
    field.reset = number(table, "reset", place, 0, field.mask());
    if (const auto* values = table["values"].as_table()) {
      for (const auto& [key, node] : *values) {
        field.values.emplace_back(
            std::string(key.str()),
            number(*values, std::string(key.str()).c_str(), place, 0, field.mask()));
      }
      std::ranges::sort(field.values, {}, &std::pair<std::string, std::uint32_t>::second);
    }
    return field;
  }

  // What all of `key`, an array of tables with a name, a number and a summary, are.
  template <class Item>
  std::vector<Item> numbers(const toml::table& table, const char* key, const char* number_key,
                            std::uint32_t limit) const {
    std::vector<Item> found;
    const auto* items = table[key].as_array();
    if (!items) return found;
    for (const auto& node : *items) {
      const auto* item = node.as_table();
      if (!item) fail(key, fmt::format("must be [[{}]]", key));
      const std::string item_name = name(*item, key);
      only_keys(*item, item_name, {"name", number_key, "summary"});
      if (!item->contains(number_key)) fail(item_name, fmt::format("needs a '{}'", number_key));
      found.emplace_back(item_name, number(*item, number_key, item_name, 0, limit),
                         summary(*item, item_name));
    }
    return found;
  }

 private:
  void read_bits(const toml::table& table, const std::string& place, Field& field) const {
    if (const auto single = table["bits"].value<std::int64_t>()) {
      if (*single < 0 || *single > 31) fail(place, "'bits' must be within 31 to 0");
      field.msb = field.lsb = static_cast<unsigned>(*single);
      return;
    }
    const auto text = table["bits"].value_or<std::string>("");
    unsigned msb = 0;
    unsigned lsb = 0;
    char rest = 0;
    const int found = std::sscanf(text.c_str(), "%u:%u%c", &msb, &lsb, &rest);
    if (found == 1 && text.find(':') == std::string::npos)
      lsb = msb;
    else if (found != 2)
      fail(place, "'bits' must be a number or \"msb:lsb\"");
    if (msb > 31 || lsb > msb) fail(place, "'bits' must be within 31 to 0, the higher first");
    field.msb = msb;
    field.lsb = lsb;
  }

  void read_type(const toml::table& table, const std::string& place, Field& field) const {
    const auto text = table["type"].value_or<std::string>(field.width() == 1 ? "bit" : "unsigned");
    if (text == "bit") {
      if (field.width() != 1) fail(place, "type bit has one bit");
      field.type = FieldType::bit;
    } else if (text == "unsigned") {
      field.type = FieldType::unsigned_number;
    } else if (text == "signed") {
      field.type = FieldType::signed_number;
    } else if (text == "bits") {
      field.type = FieldType::bits;
    } else {
      fail(place, "'type' must be bit, unsigned, signed or bits");
    }
  }

  std::string file_;
};

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
  if (const auto* access = wide["access_" + half].as_string())
    result.insert_or_assign("access", *access);
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
  if (result.read_event && !result.readable())
    reader.fail(place, "read_event on a write-only register");
  if (result.write_event && !result.writable())
    reader.fail(place, "write_event on a read-only register");

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
  toml::table table;
  try {
    table = toml::parse_file(file.string());
  } catch (const toml::parse_error& error) {
    reader.fail(fmt::format("line {}", error.source().begin.line),
                std::string(error.description()));
  }
  reader.only_keys(table, "top level",
                   {"name", "address", "summary", "constant", "interrupt", "register"});
  Peripheral peripheral;
  peripheral.name = reader.name(table, "top level");
  peripheral.summary = reader.summary(table, "top level");
  peripheral.address = reader.number(table, "address", "top level", 1, 0xFFFF'F000u);
  if (peripheral.address % window_bytes != 0) reader.fail("address", "must be a multiple of 4096");
  const auto* registers = table["register"].as_array();
  if (!registers || registers->empty()) reader.fail("top level", "needs at least one [[register]]");
  unsigned next_offset = 0;
  std::set<std::string> names;
  const auto add = [&](const toml::table& described) {
    peripheral.registers.push_back(read_register(reader, described, next_offset));
    const std::string& name = peripheral.registers.back().name;
    if (!names.insert(name).second) reader.fail(name, "is described twice");
  };
  for (const auto& node : *registers) {
    const auto* described = node.as_table();
    if (!described) reader.fail("top level", "'register' must be [[register]]");
    if (is_wide(*described)) {
      peripheral.wide_registers.push_back(read_wide(reader, *described));
      add(half_of(*described, "low"));
      add(half_of(*described, "high"));
    } else {
      add(*described);
    }
  }
  peripheral.constants =
      reader.numbers<Constant>(table, "constant", "value", std::numeric_limits<int>::max());
  peripheral.interrupts = reader.numbers<Interrupt>(table, "interrupt", "number", 31);
  for (Interrupt& interrupt : peripheral.interrupts) interrupt.peripheral = peripheral.name;
  return peripheral;
}

}  // namespace register_generator
