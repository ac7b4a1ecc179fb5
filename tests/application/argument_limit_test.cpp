// SPDX-License-Identifier: Apache-2.0
// The checks of a command's arguments, on rows defined by the test.
#include "application/argument_limit.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "gcode/parser.hpp"

namespace application_test {
namespace {

using application::ArgumentLimit;
using application::Check;

// Why the line is refused; empty where it is not.
std::string refusal(std::string_view line, application::ArgumentLimits limits) {
  const auto command = gcode::parse(line).value();
  const auto* limit = application::violated(command, limits);
  return limit != nullptr ? std::string(application::describe(command, *limit).view()) : "";
}

TEST(argument_limit, refuses_what_is_out_of_range_with_letter_and_range) {
  constexpr ArgumentLimit limits[]{
      {.letter = 'S', .check = Check::refused, .least = -2, .most = 30}};
  constexpr const char* text = "echo:S not within -2 to 30";
  EXPECT_EQ(refusal("M1000 S-3", limits), text);
  EXPECT_EQ(refusal("M1000 S31", limits), text);
  EXPECT_EQ(refusal("M1000 S", limits), text);
  EXPECT_EQ(refusal("M1000 S-2", limits), "");
  EXPECT_EQ(refusal("M1000 S30.9", limits), "");
  EXPECT_EQ(refusal("M1000", limits), "");
}

TEST(argument_limit, refuses_a_letter_that_lacks_its_number) {
  constexpr ArgumentLimit limits[]{{.letter = 'X', .check = Check::number},
                                   {.letter = 'Y', .check = Check::number}};
  EXPECT_EQ(refusal("G1 X1 Y", limits), "echo:Number missing after Y");
  EXPECT_EQ(refusal("G1 X Y", limits), "echo:Number missing after X");
  EXPECT_EQ(refusal("G1 X1 Z", limits), "");
}

TEST(argument_limit, refuses_a_command_that_lacks_what_it_requires) {
  constexpr ArgumentLimit limits[]{{.letter = 'R', .check = Check::number, .required = true}};
  EXPECT_EQ(refusal("G2 X1", limits), "echo:Parameter R missing");
  EXPECT_EQ(refusal("G2 X1 R", limits), "echo:Number missing after R");
  EXPECT_EQ(refusal("G2 X1 R5", limits), "");
}

TEST(argument_limit, refuses_a_tool_that_is_not_there_in_words_of_marlin) {
  constexpr ArgumentLimit limits[]{{.letter = 'T', .check = Check::tool}};
  EXPECT_EQ(refusal("M104 S200 T1", limits), "echo:M104 Invalid extruder 1");
  EXPECT_EQ(refusal("M104 S200 T0", limits), "");
  EXPECT_EQ(refusal("M104 S200 T", limits), "");
}

TEST(argument_limit, cuts_a_value_to_the_range_of_its_letter_alone) {
  constexpr ArgumentLimit limits[]{
      {.letter = 'S', .check = Check::clamped, .least = 1, .most = 60}};
  EXPECT_EQ(application::clamped(limits, 'S', 61, 1), 60);
  EXPECT_EQ(application::clamped(limits, 'S', 0, 1), 1);
  EXPECT_EQ(application::clamped(limits, 'S', 60'000'001, 1'000'000), 60'000'000);
  EXPECT_EQ(application::clamped(limits, 'S', 59'999'999, 1'000'000), 59'999'999);
  EXPECT_EQ(application::clamped(limits, 'P', 61, 1), 61);
  EXPECT_EQ(refusal("M1000 S61", limits), "");
}

}  // namespace
}  // namespace application_test
