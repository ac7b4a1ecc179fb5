// SPDX-License-Identifier: Apache-2.0
// Reads entries of a TOML table.
#include "tools/wiring/toml_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace wiring {

void TomlReader::fail(const std::string& what) const {
  throw std::runtime_error(fmt::format("{}: {}", place_, what));
}

void TomlReader::only(std::initializer_list<std::string_view> allowed) const {
  for (const auto& [key, node] : table_) {
    if (std::ranges::find(allowed, key.str()) == allowed.end()) {
      fail(fmt::format("unknown entry '{}'", key.str()));
    }
  }
}

std::string TomlReader::text(std::string_view key) const {
  const auto value = table_[key].value<std::string>();
  if (!value) fail(fmt::format("'{}' must be a text", key));
  return *value;
}

std::string TomlReader::text_or(std::string_view key, std::string_view otherwise) const {
  return has(key) ? text(key) : std::string(otherwise);
}

double TomlReader::number(std::string_view key) const {
  const auto value = table_[key].value<double>();
  if (!value) fail(fmt::format("'{}' must be a number", key));
  return *value;
}

double TomlReader::number_or(std::string_view key, double otherwise) const {
  return has(key) ? number(key) : otherwise;
}

bool TomlReader::flag(std::string_view key) const {
  if (!has(key)) return false;
  const auto value = table_[key].value<bool>();
  if (!value) fail(fmt::format("'{}' must be true or false", key));
  return *value;
}

std::vector<std::string> TomlReader::texts(std::string_view key) const {
  const auto* array = table_[key].as_array();
  if (array == nullptr) fail(fmt::format("'{}' must be an array of texts", key));
  std::vector<std::string> list;
  for (const auto& node : *array) {
    const auto value = node.value<std::string>();
    if (!value) fail(fmt::format("'{}' must be an array of texts", key));
    list.push_back(*value);
  }
  return list;
}

std::vector<double> TomlReader::numbers(std::string_view key) const {
  const auto* array = table_[key].as_array();
  if (array == nullptr) fail(fmt::format("'{}' must be an array of numbers", key));
  std::vector<double> list;
  for (const auto& node : *array) {
    const auto value = node.value<double>();
    if (!value) fail(fmt::format("'{}' must be an array of numbers", key));
    list.push_back(*value);
  }
  return list;
}

TomlReader TomlReader::table(std::string_view key) const {
  const auto* table = table_[key].as_table();
  if (table == nullptr) fail(fmt::format("'{}' must be a table", key));
  return {*table, fmt::format("{}, {}", place_, key)};
}

std::vector<TomlReader> TomlReader::tables(std::string_view key) const {
  std::vector<TomlReader> list;
  if (!has(key)) return list;
  const auto* array = table_[key].as_array();
  if (array == nullptr) fail(fmt::format("'{}' must be an array of tables", key));
  for (const auto& node : *array) {
    const auto* table = node.as_table();
    if (table == nullptr) fail(fmt::format("'{}' must be an array of tables", key));
    // A table is known by its name, or its designator.
    const auto name = (*table)["name"].value<std::string>();
    const auto ref = (*table)["ref"].value<std::string>();
    list.emplace_back(*table,
                      fmt::format("{}, {} {}", place_, key,
                                  name ? *name : ref.value_or(fmt::format("{}", list.size() + 1))));
  }
  return list;
}

}  // namespace wiring
