// SPDX-License-Identifier: Apache-2.0
// The host reads files as a person means them, and says clearly why it cannot.
#include "sim/devices/gcode_file.hpp"

#include <gmock/gmock.h>

namespace {

using devices::parse_gcode_text;
using testing::HasSubstr;

TEST(GcodeFile, strips_comments_and_blanks_and_keeps_the_line_numbers) {
  const auto commands =
      parse_gcode_text("; head\nG28 ; home\r\n\n  G1 X1\t(move) Y2  \n;\nM84", "f");
  ASSERT_TRUE(commands);
  ASSERT_EQ(commands->size(), 3U);
  EXPECT_EQ((*commands)[0].text, "G28");
  EXPECT_EQ((*commands)[0].file_line, 2U);
  EXPECT_EQ((*commands)[1].text, "G1 X1  Y2");
  EXPECT_EQ((*commands)[1].file_line, 4U);
  EXPECT_EQ((*commands)[2].text, "M84");
  EXPECT_EQ((*commands)[2].file_line, 6U);
}

TEST(GcodeFile, sends_characters_beyond_ascii_as_question_marks) {
  const auto commands = parse_gcode_text("M117 Grüße\n; höher\nG28\n", "f");
  ASSERT_TRUE(commands);
  EXPECT_EQ(commands->front().text, "M117 Gr??e");
}

TEST(GcodeFile, refuses_what_is_no_text) {
  using namespace std::string_literals;
  for (const std::string& text : {"G28\nG1 X\0Y\n"s,
                                  "\x7f"
                                  "ELF\x01\x01"s,
                                  "G28\nG1\x80\n"s, "G1 \xc3\n"s}) {
    const auto commands = parse_gcode_text(text, "part.gcode");
    ASSERT_FALSE(commands);
    EXPECT_THAT(commands.error(), HasSubstr("part.gcode is not a G-code file: line "));
  }
}

TEST(GcodeFile, refuses_a_file_without_commands) {
  for (const char* text : {"", "\n\n", "; only\n; comments\n"}) {
    const auto commands = parse_gcode_text(text, "empty.gcode");
    ASSERT_FALSE(commands);
    EXPECT_EQ(commands.error(), "empty.gcode holds no G-code command");
  }
}

TEST(GcodeFile, names_a_file_that_is_missing_or_a_folder) {
  EXPECT_EQ(devices::read_gcode_file("no/such.gcode").error(), "no/such.gcode does not exist");
  EXPECT_EQ(devices::read_gcode_file("/").error(), "/ is not a file");
}

TEST(GcodeFile, keeps_lines_of_any_length) {
  const auto commands = parse_gcode_text("G1 X" + std::string(10'000, '1'), "f");
  ASSERT_TRUE(commands);
  EXPECT_EQ(commands->front().text.size(), 10'004U);
}

}  // namespace
