// SPDX-License-Identifier: Apache-2.0
// A file that is one S-expression, as KiCad's are.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace wiring_files {

// A word, or a list.
struct Expression {
  std::string word;
  std::vector<Expression> list;

  // The list that begins with the name, or null.
  const Expression* find(const std::string& name) const;
  // Of "(name word)", or nothing.
  std::string text(const std::string& name) const;
};

// Throws std::runtime_error where it is none, or more than one.
Expression read_expression(const std::filesystem::path& file);

}  // namespace wiring_files
