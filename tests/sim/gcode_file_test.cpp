// SPDX-License-Identifier: Apache-2.0
// The host reads files as a person means them, and says clearly why it cannot.
#include "sim/devices/gcode_file.hpp"

#include <gmock/gmock.h>

namespace {

using devices::parse_gcode_text;
using testing::HasSubstr;

TEST(GcodeFile, keeps_what_stands_behind_a_comment_in_parentheses) {
  const auto commands = parse_gcode_text(
      "(a; b) G1 X10\nG1 X1 (slow; careful) Y5 ; end (of it\nG1 X2 (abc Y5\n", "f");
  ASSERT_TRUE(commands);
  ASSERT_EQ(commands->size(), 3u);
  EXPECT_EQ((*commands)[0].text, "G1 X10");
  EXPECT_EQ((*commands)[1].text, "G1 X1  Y5");
  EXPECT_EQ((*commands)[2].text, "G1 X2 (abc Y5");  // which the firmware refuses
}

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

TEST(GcodeFile, takes_off_the_numbers_and_right_checksums_of_the_lines) {
  const auto commands = parse_gcode_text(
      "N0 M110 N0*125\nN1 G28*18 ; home\r\nn7G1X1\n N10 \nG28*77\nN-1 M110*15\n", "f");
  ASSERT_TRUE(commands) << commands.error();
  std::vector<std::string> texts;
  for (const auto& command : *commands) texts.push_back(command.text);
  EXPECT_THAT(texts, testing::ElementsAre("M110 N0", "G28", "G1X1", "G28", "M110"));
  EXPECT_EQ(commands->back().file_line, 6U);
}

TEST(GcodeFile, refuses_a_line_whose_own_checksum_is_wrong) {
  for (const char* line : {"N1 G28*19", "G28*36", "N1 G28*", "N1 G28*1x", "N1 M0*9999999999"}) {
    const auto commands = parse_gcode_text("G28\n" + std::string(line) + "\n", "part.gcode");
    ASSERT_FALSE(commands) << line;
    EXPECT_THAT(commands.error(), HasSubstr("part.gcode, line 2: "));
    EXPECT_THAT(commands.error(), HasSubstr("checksum"));
  }
}

TEST(GcodeFile, leaves_a_star_in_a_message_alone) {
  const auto commands = parse_gcode_text("M117 5*3\nM0 2*4\nG28 (a*5)\n", "f");
  ASSERT_TRUE(commands) << commands.error();
  EXPECT_EQ((*commands)[0].text, "M117 5*3");
  EXPECT_EQ((*commands)[1].text, "M0 2*4");
  EXPECT_EQ((*commands)[2].text, "G28");
}

TEST(GcodeFile, reads_comments_in_any_encoding_and_a_byte_order_mark) {
  const auto commands = parse_gcode_text(
      "\xef\xbb\xbfG28 ; f\xfcr\n; Gr\xf6\xdf"
      "e\nM84\n",
      "f");
  ASSERT_TRUE(commands) << commands.error();
  EXPECT_EQ((*commands)[0].text, "G28");
  EXPECT_EQ((*commands)[1].text, "M84");
}

TEST(GcodeFile, refuses_what_is_no_text) {
  using namespace std::string_literals;
  for (const std::string& text : {"G28\nG1 X\0Y\n"s,
                                  "\x7f"
                                  "ELF\x01\x01"s,
                                  "G28 ; \0\n"s, "G28\nG1\x80\n"s, "G1 \xc3\n"s}) {
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
