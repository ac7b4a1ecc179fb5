// SPDX-License-Identifier: Apache-2.0
// Which lines are commands, which are errors, and the position of the error.
#include "gcode/parser.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace gcode {
namespace {

using namespace std::string_literals;

Command parsed(std::string_view line) {
  const auto command = parse(line);
  EXPECT_TRUE(command.has_value())
      << line << ": " << describe(command.error()) << " at " << command.error().position;
  return command.value_or(Command{});
}

struct NumberCase {
  std::string_view written;
  std::int64_t millionths;
};

TEST(parser, reads_every_form_of_a_number) {
  const std::vector<NumberCase> cases{
      {"0", 0},
      {"10", 10'000'000},
      {"10.", 10'000'000},
      {".2", 200'000},
      {"-.5", -500'000},
      {"+10", 10'000'000},
      {"+.25", 250'000},
      {"-0", 0},
      {"-12.345678", -12'345'678},
      {"000123.4500000", 123'450'000},
      {"0.0000004", 0},
      {"0.0000005", 1},
      {"0.000000499", 0},
      {"-0.0000005", -1},
      {"1.9999995", 2'000'000},
      {"1.99999949", 1'999'999},
      {"4294967295.999999", 4'294'967'295'999'999},
      {"-4294967295.999999", -4'294'967'295'999'999},
  };
  for (const NumberCase& number : cases) {
    const std::string line = "G1 X" + std::string(number.written);
    const Command command = parsed(line);
    EXPECT_EQ(command.value('X'), number.millionths) << line;
  }
}

struct PositionCase {
  std::string_view written;
  std::uint32_t whole, billionths;
  bool negative;
};

TEST(parser, keeps_nine_decimals_of_a_position) {
  const std::vector<PositionCase> cases{
      {"10", 10, 0, false},
      {"0.123456789", 0, 123'456'789, false},
      {"-.5", 0, 500'000'000, true},
      {"1.000000001", 1, 1, false},
      {"0.0000000004", 0, 0, false},
      {"0.0000000005", 0, 1, false},
      {"-0.99999999949", 0, 999'999'999, true},
      {"1.9999999995", 2, 0, false},
      {"4294967295.999999999", 4'294'967'295, 999'999'999, false},
  };
  for (const PositionCase& position : cases) {
    const auto number = parsed("G1 X" + std::string(position.written)).number('X');
    ASSERT_TRUE(number) << position.written;
    EXPECT_EQ(number->whole, position.whole) << position.written;
    EXPECT_EQ(number->billionths, position.billionths) << position.written;
    EXPECT_EQ(number->negative, position.negative) << position.written;
  }
  EXPECT_FALSE(parsed("G28 X").number('X'));
}

TEST(parser, keeps_the_whole_part_apart) {
  EXPECT_EQ(parsed("M104 S205.9").integer('S'), 205);
  EXPECT_EQ(parsed("M104 S-3.9").integer('S'), -3);
  EXPECT_EQ(parsed("M104 S").integer('S'), std::nullopt);
  EXPECT_EQ(parsed("M26 S4294967295").integer('S'), 4294967295);
}

TEST(parser, reads_words_with_and_without_blanks) {
  for (const std::string_view line :
       {"G1X1Y-2Z.5F1200", "G1 X1 Y-2 Z.5 F1200", "  g1\tx1\ty-2\tz.5 f1200  ",
        "G01 X 1 Y -2 Z .5 F 1200", "G 1 X1Y-2 (lift) Z.5 F1200;and go",
        "(start)G1(now)X1(a)Y-2(b)Z.5(c)F1200(d)", "G001 X1. Y-2.Z+.5F1200."}) {
    const Command command = parsed(line);
    EXPECT_TRUE(command.is('G', 1)) << line;
    EXPECT_EQ(command.subcode, 0) << line;
    EXPECT_EQ(command.value('X'), 1'000'000) << line;
    EXPECT_EQ(command.value('Y'), -2'000'000) << line;
    EXPECT_EQ(command.value('Z'), 500'000) << line;
    EXPECT_EQ(command.value('F'), 1'200'000'000) << line;
    EXPECT_FALSE(command.has('E')) << line;
  }
}

TEST(parser, reads_commands_without_parameters) {
  EXPECT_TRUE(parsed("G1").is('G', 1));
  EXPECT_FALSE(parsed("G1").has_parameters());
  EXPECT_TRUE(parsed("M112").is('M', 112));
  EXPECT_TRUE(parsed("T0").is('T', 0));
  EXPECT_TRUE(parsed("G65535").is('G', 65535));
  const Command probe = parsed("G38.2 Z-10");
  EXPECT_EQ(probe.code, 38);
  EXPECT_EQ(probe.subcode, 2);
}

TEST(parser, reads_a_letter_without_a_number_as_a_flag) {
  for (const std::string_view line : {"G28 X Y", "G28 XY", "g28 x y ;", "G28 X(a)Y"}) {
    const Command command = parsed(line);
    EXPECT_TRUE(command.has('X')) << line;
    EXPECT_TRUE(command.has('Y')) << line;
    EXPECT_FALSE(command.has('Z')) << line;
    EXPECT_EQ(command.value('X'), std::nullopt) << line;
  }
  EXPECT_EQ(parsed("G28 X 0").value('X'), 0);
}

TEST(parser, reads_e_as_a_parameter_not_as_an_exponent) {
  const Command command = parsed("G1 X1E5");
  EXPECT_EQ(command.value('X'), 1'000'000);
  EXPECT_EQ(command.value('E'), 5'000'000);
}

TEST(parser, keeps_texts_raw) {
  EXPECT_EQ(parsed("M117 G1 X10*5 (of 7) \"hi\"  ; gone").text, "G1 X10*5 (of 7) \"hi\"");
  EXPECT_FALSE(parsed("M117 G1 X10").has_parameters());
  EXPECT_EQ(parsed("M117").text, "");
  EXPECT_EQ(parsed("M117Gr\xc3\xbc\xc3\x9f").text, "Gr\xc3\xbc\xc3\x9f");
  EXPECT_EQ(parsed("m118 A1 action:pause").text, "A1 action:pause");
  EXPECT_EQ(parsed("M23 WASHER~1.GCO").text, "WASHER~1.GCO");
  EXPECT_EQ(parsed("M28 /a b.g").text, "/a b.g");
}

TEST(parser, reads_messages_behind_parameters) {
  const Command wait = parsed("M0 S5 Change the filament");
  EXPECT_EQ(wait.value('S'), 5'000'000);
  EXPECT_EQ(wait.text, "Change the filament");
  EXPECT_EQ(parsed("M1 \"quoted\"").text, "\"quoted\"");
  const Command model = parsed("M862.3 P \"MK3S\" ; printer");
  EXPECT_EQ(model.subcode, 3);
  EXPECT_TRUE(model.has('P'));
  EXPECT_EQ(model.text, "MK3S");
}

TEST(parser, ignores_any_byte_in_a_comment) {
  EXPECT_TRUE(parsed("G28 ; \xff\x01 G1 X5").is('G', 28));
  EXPECT_TRUE(parsed("G28 (\xc3\xbc;) X").has('X'));
}

struct ErrorCase {
  std::string line;
  ParseFault fault;
  std::uint32_t position;
};

TEST(parser, names_each_fault_and_its_position) {
  const std::vector<ErrorCase> cases{
      {"", ParseFault::empty_line, 0},
      {"  \t", ParseFault::empty_line, 3},
      {"; comment", ParseFault::empty_line, 9},
      {"(a) (b)", ParseFault::empty_line, 7},
      {"X10", ParseFault::unknown_letter, 0},
      {" F1200", ParseFault::unknown_letter, 1},
      {"N5 G1", ParseFault::unknown_letter, 0},
      {"93", ParseFault::unknown_letter, 0},
      {"G", ParseFault::missing_code, 1},
      {"GX1", ParseFault::missing_code, 1},
      {"G-1", ParseFault::missing_code, 1},
      {"T?", ParseFault::missing_code, 1},
      {"G65536", ParseFault::code_overflow, 5},
      {"M99999999999999999999", ParseFault::code_overflow, 5},
      {"G38.", ParseFault::malformed_code, 4},
      {"G38.x", ParseFault::malformed_code, 4},
      {"G38.256", ParseFault::malformed_code, 6},
      {"G38.2.1", ParseFault::malformed_code, 5},
      {"G1-2", ParseFault::malformed_code, 2},
      {"G1 1", ParseFault::unexpected_character, 3},
      {"G1 X1 ,Y2", ParseFault::unexpected_character, 6},
      {"G1 X1*53", ParseFault::unexpected_character, 5},
      {"G1 X1 5", ParseFault::unexpected_character, 6},
      {"G1 X.", ParseFault::malformed_number, 4},
      {"G1 X-", ParseFault::malformed_number, 4},
      {"G1 X+Y1", ParseFault::malformed_number, 4},
      {"G1 X--1", ParseFault::malformed_number, 4},
      {"G1 X1.2.3", ParseFault::malformed_number, 7},
      {"G1 X1-2", ParseFault::malformed_number, 5},
      {"G1 X4294967296", ParseFault::number_overflow, 4},
      {"G1 X-99999999999999999999", ParseFault::number_overflow, 4},
      {"G1 X4294967295.9999999995", ParseFault::number_overflow, 4},
      {"G1 X1 X2", ParseFault::duplicate_letter, 6},
      {"G28 X x", ParseFault::duplicate_letter, 6},
      {"G90 G1 X1", ParseFault::second_command, 4},
      {"G1 X1 M106", ParseFault::second_command, 6},
      {"G1 X1\0Y2"s, ParseFault::unprintable_byte, 5},
      {"\x80G1", ParseFault::unprintable_byte, 0},
      {"G1 X1 \xc3\xbc", ParseFault::unprintable_byte, 6},
      {"M117 bell\x07", ParseFault::unprintable_byte, 9},
      {"G1 X1 (lift", ParseFault::unclosed_comment, 6},
      {"M862.3 P \"MK3S", ParseFault::unclosed_quote, 9},
  };
  for (const ErrorCase& wrong : cases) {
    const auto command = parse(wrong.line);
    ASSERT_FALSE(command.has_value()) << wrong.line;
    EXPECT_EQ(command.error(), (ParseError{wrong.fault, wrong.position}))
        << wrong.line << ": " << describe(command.error()) << " at " << command.error().position;
  }
}

TEST(parser, has_a_phrase_of_its_own_for_each_fault) {
  std::vector<std::string_view> phrases;
  for (int fault = 0; fault <= static_cast<int>(ParseFault::unclosed_quote); ++fault) {
    const std::string_view phrase = describe(static_cast<ParseFault>(fault));
    EXPECT_FALSE(phrase.empty());
    EXPECT_EQ(std::ranges::count(phrases, phrase), 0) << phrase;
    phrases.push_back(phrase);
  }
}

TEST(parser, takes_a_move_after_g53_whatever_is_between) {
  for (const char* line : {"G53 G1 X2", "g53g1x2", "G53 (for once) G1 X2", "G53\tG01 X2"}) {
    const Command command = parsed(line);
    EXPECT_TRUE(command.is('G', 1)) << line;
    EXPECT_TRUE(command.in_machine_coordinates) << line;
    EXPECT_EQ(command.value('X'), 2'000'000) << line;
  }
  EXPECT_FALSE(parsed("G53").in_machine_coordinates);
}

// The executor parses each line into the same command.
TEST(parser, leaves_nothing_of_the_line_before_in_a_command) {
  const auto all_of = [](const Command& command) {
    std::string text = std::string(1, command.letter) + std::to_string(command.code) + "." +
                       std::to_string(command.subcode) +
                       (command.in_machine_coordinates ? " machine " : " ") +
                       std::string(command.text);
    for (char letter = 'A'; letter <= 'Z'; ++letter) {
      if (command.has(letter)) text += letter;
      if (const auto value = command.value(letter)) text += std::to_string(*value);
    }
    return text;
  };
  const std::vector<std::string_view> lines{
      "G53 G1 X-1.5 Y2 E.25 F600", "G38.2 Z-3", "M117 text", "G28 X", "M862.3 P\"MK3S\"",
      "EXCLUDE_OBJECT_END",        "G1 X1 X2",  "T0",        "M105"};
  for (const std::string_view before : lines) {
    for (const std::string_view line : lines) {
      Command used;
      static_cast<void>(parse(before, used));
      if (parse(line, used)) continue;
      EXPECT_EQ(all_of(used), all_of(parsed(line))) << before << ", then " << line;
    }
  }
}

}  // namespace
}  // namespace gcode
