// SPDX-License-Identifier: Apache-2.0
// Reads one table of a machine description: every value is wanted, of the right type and within
// bounds, and an entry that is not known is an error too.
#pragma once

#include <cstdint>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <toml++/toml.hpp>
#include <vector>

namespace machine_generator {

// Says the file, the line and full name of the entry (the line of its table where it is missing)
// and what is wrong with it.
class DescriptionError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class Reader {
 public:
  // The whole file. Throws DescriptionError where it is missing, no regular file, larger
  // than 1 MiB or not TOML.
  static toml::table parse(const std::filesystem::path& file);
  // The same of a file's text; `name` is for the message.
  static toml::table parse(std::string_view text, const std::filesystem::path& name);

  // `place` is the table's full name, empty for the file itself.
  Reader(const std::filesystem::path& file, const toml::table& table, std::string place = {});

  bool has(const std::string& key) const { return table_.contains(key); }
  Reader table(const std::string& key);
  std::string text(const std::string& key);
  bool truth(const std::string& key);
  std::int64_t whole(const std::string& key, std::int64_t least, std::int64_t most);
  // A decimal number times `scale`, which must give a whole number within the bounds: 62.745
  // steps/mm are 62745 steps/m, but 0.0001 steps/mm are refused.
  std::int64_t scaled(const std::string& key, std::int64_t scale, std::int64_t least,
                      std::int64_t most);

  // So many such numbers, of any sign of the bounds.
  std::vector<std::int64_t> scaled_list(const std::string& key, std::int64_t scale,
                                        std::int64_t least, std::int64_t most, std::size_t count);

  // Every key has been read; throws on the first that has not.
  void finish() const;

  [[noreturn]] void fail(const std::string& key, const std::string& what) const;

 private:
  const toml::node& node(const std::string& key);
  std::int64_t scaled_value(const std::string& key, const toml::node& found, std::int64_t scale,
                            std::int64_t least, std::int64_t most) const;

  std::string file_;
  const toml::table& table_;
  std::string place_;
  std::set<std::string> used_;
};

}  // namespace machine_generator
