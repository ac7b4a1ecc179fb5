// SPDX-License-Identifier: Apache-2.0
// Entries of a TOML table; what is missing, unknown or of another type is named with its place.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <toml++/toml.hpp>
#include <vector>

namespace wiring {

class TomlReader {
 public:
  TomlReader(const toml::table& table, std::string place)
      : table_(table), place_(std::move(place)) {}

  [[noreturn]] void fail(const std::string& what) const;
  void only(std::initializer_list<std::string_view> allowed) const;
  bool has(std::string_view key) const { return table_.contains(key); }

  std::string text(std::string_view key) const;
  std::string text_or(std::string_view key, std::string_view otherwise) const;
  double number(std::string_view key) const;
  double number_or(std::string_view key, double otherwise) const;
  bool flag(std::string_view key) const;
  std::vector<std::string> texts(std::string_view key) const;
  std::vector<double> numbers(std::string_view key) const;
  TomlReader table(std::string_view key) const;
  // Of an array of tables; none where the key is missing.
  std::vector<TomlReader> tables(std::string_view key) const;

 private:
  const toml::table& table_;
  std::string place_;
};

}  // namespace wiring
