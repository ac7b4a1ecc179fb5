// SPDX-License-Identifier: Apache-2.0
// All ways of writing the same line, combined: each is the same command, to the last decimal.
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <string_view>

#include "gcode/parser.hpp"

namespace gcode {
namespace {

using Texts = std::initializer_list<std::string_view>;

// The same three numbers.
struct Numbers {
  std::string_view x, y, z;  // 12.5, -0.5, 0
};

std::string in_lower_case(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

void expect_magnitude(const Command& command, char letter, std::uint32_t whole,
                      std::uint32_t billionths, std::string_view line) {
  const auto number = command.number(letter);
  ASSERT_TRUE(number) << line;
  EXPECT_EQ(number->whole, whole) << line;
  EXPECT_EQ(number->billionths, billionths) << line;
}

void expect_the_move(const std::string& line) {
  const auto command = parse(line);
  ASSERT_TRUE(command) << line << ": " << describe(command.error());
  EXPECT_TRUE(command->is('G', 1)) << line;
  EXPECT_EQ(command->subcode, 0) << line;
  expect_magnitude(*command, 'X', 12, 500'000'000, line);
  expect_magnitude(*command, 'Y', 0, 500'000'000, line);
  expect_magnitude(*command, 'Z', 0, 0, line);
  EXPECT_EQ(command->value('X'), 12'500'000) << line;
  EXPECT_EQ(command->value('Y'), -500'000) << line;
  EXPECT_EQ(command->integer('F'), 1200) << line;
  EXPECT_FALSE(command->has_besides(Command::set_of("XYZF"))) << line;
}

TEST(parser_matrix, reads_every_combination_of_spellings_as_the_same_move) {
  constexpr std::array<Numbers, 5> numbers{{{"12.5", "-.5", "0"},
                                            {"+12.5", "-0.5", "+0"},
                                            {"0012.5", "-00.50", ".0"},
                                            {"12.500", "-.5000000000", "0."},
                                            {"+0012.50000000000", "-0.500", "-0"}}};
  for (const std::string_view name : Texts{"G1", "G01", "G001", "G 1"}) {
    for (const std::string_view before : Texts{"", " ", "\t", "(a)", " (G2) "}) {
      for (const std::string_view gap : Texts{"", " ", "\t  ", "(lift)", " (X9) "}) {
        for (const std::string_view inside : Texts{"", " ", "\t"}) {
          for (const std::string_view end :
               Texts{"", " ", ";x", " ; G1 X9", "(X9)", "(a)(b) ;c("}) {
            for (const Numbers& each : numbers) {
              const auto word = [&](char letter, std::string_view number) {
                return std::string(gap) + letter + std::string(inside) + std::string(number);
              };
              const std::string line = std::string(before) + std::string(name) + word('X', each.x) +
                                       word('Y', each.y) + word('Z', each.z) + word('F', "1200") +
                                       std::string(end);
              expect_the_move(line);
              expect_the_move(in_lower_case(line));
              if (HasFatalFailure()) return;
            }
          }
        }
      }
    }
  }
}

TEST(parser_matrix, reads_empty_words_between_others_as_flags) {
  for (const std::string_view line :
       {"G28 X Y5 Z", "g28xy5z", "G28 X(1)Y 5 Z ;5", "G28\tX\tY5.\tZ(7)", "G028X Y+05 Z "}) {
    const auto command = parse(line);
    ASSERT_TRUE(command) << line;
    for (const char letter : {'X', 'Z'}) {
      EXPECT_TRUE(command->has(letter)) << line;
      EXPECT_FALSE(command->has_number(letter)) << line;
    }
    EXPECT_EQ(command->integer('Y'), 5) << line;
  }
}

// Up to nine decimals nothing is rounded, whatever stands before the point.
TEST(parser_matrix, reads_all_lengths_of_decimals_exactly) {
  std::uint32_t unit = 1'000'000'000;  // billionths of the last decimal
  for (std::size_t decimals = 1; decimals <= 9; ++decimals) {
    unit /= 10;
    const std::uint32_t most = 1'000'000'000 / unit - 1;
    for (const std::uint32_t last :
         {std::uint32_t{0}, std::uint32_t{1}, most / 3, most / 2, most}) {
      std::string fraction = std::to_string(last);
      fraction.insert(0, decimals - fraction.size(), '0');
      for (const std::uint32_t whole : {0U, 1U, 9U, 10U, 255U, 65'536U, 4'294'967'295U}) {
        for (const std::string_view sign : Texts{"", "+", "-", "-00", "+0"}) {
          const std::string line =
              "G1 X" + std::string(sign) + std::to_string(whole) + "." + fraction + "Y1";
          const auto command = parse(line);
          ASSERT_TRUE(command) << line;
          expect_magnitude(*command, 'X', whole, last * unit, line);
          EXPECT_EQ(command->number('X')->negative, sign.starts_with('-')) << line;
          EXPECT_EQ(command->integer('Y'), 1) << line;
        }
      }
    }
  }
}

}  // namespace
}  // namespace gcode
