// SPDX-License-Identifier: Apache-2.0
// Rules for the form of sources: columns, lines, comments.
#include <gtest/gtest.h>

#include <regex>

#include "tests/repository/tree.hpp"

namespace {

namespace fs = std::filesystem;
using ::files::text_of;
using repository::files;
using repository::is_generated;
using repository::lines_of;
using repository::project;
using repository::source_extensions;

TEST(repository, lines_are_at_most_100_columns_wide_in_cpp_and_110_in_vhdl) {
  for (const fs::path& file : files({".vhd", ".cpp", ".hpp"})) {
    if (is_generated(file)) continue;
    const int most = file.extension() == ".vhd" ? 110 : 100;
    std::istringstream text(text_of(project / file));
    std::string line;
    for (int number = 1; std::getline(text, line); ++number) {
      const auto columns = std::ranges::count_if(
          line, [](char c) { return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u; });
      EXPECT_LE(columns, most) << file << ":" << number;
    }
  }
}

// A file is about one thing, and a screen or five. What people have not split yet is named here.
TEST(repository, no_source_file_is_longer_than_300_lines) {
  constexpr auto most = 300;
  std::set<std::string> extensions = source_extensions;
  extensions.insert({".psl", ".py", ".smt2", ".tcl", ".gdb"});
  for (const fs::path& file : files(extensions)) {
    if (is_generated(file)) continue;
    const std::string text = text_of(project / file);
    EXPECT_LE(std::ranges::count(text, '\n'), most)
        << file << ": split it by what its parts are about";
  }
}

TEST(repository, no_comment_ends_with_a_line_of_one_word) {
  const std::regex comment(R"(^ *(//|--) .*)"), one_word(R"(^ *(//|--) [^ ]+$)");
  for (const fs::path& file : files({".cpp", ".hpp", ".vhd", ".psl"})) {
    if (is_generated(file)) continue;
    const auto lines = lines_of(file);
    for (std::size_t i = 1; i + 1 < lines.size(); ++i) {
      const bool is_last = !std::regex_match(lines[i + 1], comment);
      const bool is_orphan = is_last && std::regex_match(lines[i], one_word) &&
                             std::regex_match(lines[i - 1], comment);
      EXPECT_FALSE(is_orphan) << file << ":" << i + 1 << ": " << lines[i];
    }
  }
}

}  // namespace
