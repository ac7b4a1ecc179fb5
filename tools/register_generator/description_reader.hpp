// SPDX-License-Identifier: Apache-2.0
// Reads the values of one description file and refuses, with the place in it, what is not legal.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>
#include <toml++/toml.hpp>
#include <vector>

#include "register_generator/description.hpp"

namespace register_generator {

// All throw DescriptionError, which names the file and `place`.
class Reader {
 public:
  explicit Reader(const std::filesystem::path& file) : file_(file) {}

  const std::filesystem::path& file() const { return file_; }
  // The whole file.
  toml::table table() const;

  [[noreturn]] void fail(const std::string& place, const std::string& what) const;
  void only_keys(const toml::table& table, const std::string& place,
                 std::initializer_list<std::string_view> allowed) const;
  std::string name(const toml::table& table, const std::string& place) const;
  std::string summary(const toml::table& table, const std::string& place) const;
  // From 0 to `limit`.
  std::uint32_t number(const toml::table& table, const char* key, const std::string& place,
                       std::uint32_t otherwise, std::uint32_t limit) const;
  bool flag(const toml::table& table, const char* key, const std::string& place) const;
  Access access(const toml::table& table, const std::string& place,
                const char* key = "access") const;
  Field field(const toml::table& table, const std::string& register_place) const;

  // The files that a description includes, in this order.
  std::vector<std::filesystem::path> includes(const toml::table& table) const;

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
  void read_bits(const toml::table& table, const std::string& place, Field& field) const;
  void read_type(const toml::table& table, const std::string& place, Field& field) const;

  std::filesystem::path file_;
};

}  // namespace register_generator
