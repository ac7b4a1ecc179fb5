// SPDX-License-Identifier: Apache-2.0
// Real sliced files: every line parses, and parsing loses nothing of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <string>

#include "directories.hpp"
#include "gcode/parser.hpp"

namespace gcode {
namespace {

struct Contents {
  std::map<std::string, int> commands;
  int empty_lines = 0;
  int lines = 0;
  std::int64_t largest_z = 0;
};

// Independent of the parser: the first word of a line without its comment.
std::string first_word(const std::string& line) {
  const std::string bare = line.substr(0, line.find(';'));
  const std::size_t start = bare.find_first_not_of(" \t\r");
  if (start == std::string::npos) return "";
  return bare.substr(start, bare.find_first_of(" \t\r", start) - start);
}

Contents read_file(const std::string& name) {
  Contents contents;
  std::ifstream file(std::string(PROJECT_DIRECTORY "/examples/") + name);
  EXPECT_TRUE(file.is_open()) << name;
  for (std::string line; std::getline(file, line);) {
    ++contents.lines;
    const std::string word = first_word(line);
    const auto command = parse(line);
    if (word.empty()) {
      EXPECT_TRUE(!command && command.error().fault == ParseFault::empty_line) << line;
      ++contents.empty_lines;
      continue;
    }
    EXPECT_TRUE(command.has_value())
        << name << ":" << contents.lines << ": " << line << ": " << describe(command.error());
    if (!command) continue;
    EXPECT_EQ(command->letter + std::to_string(command->code), word) << line;
    ++contents.commands[word];
    contents.largest_z = std::max(contents.largest_z, command->value('Z').value_or(0));
  }
  return contents;
}

TEST(sliced_file, washer_parses_line_by_line) {
  const Contents washer = read_file("washer.gcode");
  EXPECT_EQ(washer.lines, 2737);
  EXPECT_GT(washer.commands.at("G1"), 1000);
  EXPECT_EQ(washer.commands.at("M109"), 1);
  EXPECT_EQ(washer.commands.at("G28"), 2);
  EXPECT_GT(washer.largest_z, 5'000'000);
}

TEST(sliced_file, the_other_examples_parse_line_by_line) {
  EXPECT_EQ(read_file("cube20_02_marlin.gcode").lines, 13307);
  EXPECT_EQ(read_file("endstop_bracket_02_marlin.gcode").lines, 23127);
}

}  // namespace
}  // namespace gcode
