// SPDX-License-Identifier: Apache-2.0
// What names, numbers, fields and accesses of a description may be.
#include "register_generator/description_reader.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>

#include "register_generator/reserved_words.hpp"

namespace register_generator {

toml::table Reader::table() const {
  try {
    return toml::parse_file(file_.string());
  } catch (const toml::parse_error& error) {
    fail(fmt::format("line {}", error.source().begin.line), std::string(error.description()));
  }
}

void Reader::fail(const std::string& place, const std::string& what) const {
  throw DescriptionError(fmt::format("{}: {}: {}", file_.string(), place, what));
}

void Reader::only_keys(const toml::table& table, const std::string& place,
                       std::initializer_list<std::string_view> allowed) const {
  for (const auto& [key, node] : table) {
    if (std::ranges::find(allowed, key.str()) == allowed.end()) {
      fail(place, fmt::format("unknown key '{}'", key.str()));
    }
  }
}

std::string Reader::name(const toml::table& table, const std::string& place) const {
  const auto text = table["name"].value<std::string>();
  if (!text) fail(place, "needs a 'name'");
  const bool legal = !text->empty() && std::islower(static_cast<unsigned char>(text->front())) &&
                     std::ranges::all_of(*text, [](unsigned char c) {
                       return std::islower(c) || std::isdigit(c) || c == '_';
                     });
  if (!legal) fail(place, fmt::format("name '{}' is not lower snake_case", *text));
  if (is_reserved(*text)) fail(place, fmt::format("name '{}' is a reserved word", *text));
  return *text;
}

std::string Reader::summary(const toml::table& table, const std::string& place) const {
  const auto text = table["summary"].value<std::string>();
  if (!text || text->empty()) fail(place, "needs a 'summary'");
  return *text;
}

std::uint32_t Reader::number(const toml::table& table, const char* key, const std::string& place,
                             std::uint32_t otherwise, std::uint32_t limit) const {
  if (!table.contains(key)) return otherwise;
  const auto value = table[key].value<std::int64_t>();
  if (!value || *value < 0 || *value > limit) {
    fail(place, fmt::format("'{}' must be a whole number from 0 to {}", key, limit));
  }
  return static_cast<std::uint32_t>(*value);
}

bool Reader::flag(const toml::table& table, const char* key, const std::string& place) const {
  if (!table.contains(key)) return false;
  const auto value = table[key].value<bool>();
  if (!value) fail(place, fmt::format("'{}' must be true or false", key));
  return *value;
}

Access Reader::access(const toml::table& table, const std::string& place, const char* key) const {
  const auto text = table[key].value_or<std::string>("");
  if (text == "read") return Access::read;
  if (text == "write") return Access::write;
  if (text == "read_write") return Access::read_write;
  if (text == "external") return Access::external;
  fail(place, fmt::format("'{}' must be read, write, read_write or external", key));
}

Field Reader::field(const toml::table& table, const std::string& register_place) const {
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

void Reader::read_bits(const toml::table& table, const std::string& place, Field& field) const {
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
  if (found == 1 && text.find(':') == std::string::npos) {
    lsb = msb;
  } else if (found != 2) {
    fail(place, "'bits' must be a number or \"msb:lsb\"");
  }
  if (msb > 31 || lsb > msb) fail(place, "'bits' must be within 31 to 0, the higher first");
  field.msb = msb;
  field.lsb = lsb;
}

void Reader::read_type(const toml::table& table, const std::string& place, Field& field) const {
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

std::vector<std::filesystem::path> Reader::includes(const toml::table& table) const {
  std::vector<std::filesystem::path> files;
  if (!table.contains("include")) return files;
  const auto* names = table["include"].as_array();
  if (!names) fail("include", "must be an array of file names");
  for (const auto& node : *names) {
    const auto name = node.value<std::string>();
    if (!name) fail("include", "must be an array of file names");
    files.push_back(file_.parent_path() / *name);
  }
  return files;
}

}  // namespace register_generator
