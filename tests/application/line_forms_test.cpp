// SPDX-License-Identifier: Apache-2.0
// Lines as hosts end and number them, from the wire to the motor.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "tests/application/dialogue.hpp"

namespace application_test {
namespace {

using Texts = std::initializer_list<std::string_view>;

std::string numbered(int number, std::string_view command, std::string_view before_checksum) {
  const std::string line =
      fmt::format("N{}{}{}{}", number, before_checksum, command, before_checksum);
  unsigned char checksum = 0;
  for (const char c : line) checksum ^= static_cast<unsigned char>(c);
  return fmt::format("{}*{}", line, checksum);
}

// Every line moves on by a millimetre.
TEST(line_forms, are_executed_to_the_same_step) {
  Printer printer;
  printer.talk("-> G28\n<- ok\n-> G91\n<- ok");
  int number = 0;
  int millimeters = 0;
  for (const std::string_view command :
       Texts{"G1 X1 F6000", "g1x1f6000", "G01 X+01. F6000", "G1(X9)X1.000F6000",
             " G1  X 1  F 6000 ", "G1\tX1\tF6000"}) {
    for (const std::string_view end : Texts{"", "\r", " ", "\t", " \r"}) {
      printer.send(std::string(command) + std::string(end));
      EXPECT_EQ(printer.reply(), "ok") << command;
      printer.send(std::string(command) + " ; X9" + std::string(end));
      EXPECT_EQ(printer.reply(), "ok") << command;
      for (const std::string_view gap : Texts{"", " ", "\t"}) {
        printer.send(numbered(++number, command, gap) + std::string(end));
        EXPECT_EQ(printer.reply(), "ok") << command;
      }
      millimeters += 5;
      printer.talk("-> M400\n<- ok");
      EXPECT_EQ(printer.chip.position[0], 80 * millimeters) << command;
    }
  }
}

// A wrong checksum moves nothing, however the line ends.
TEST(line_forms, are_asked_for_again_where_the_checksum_is_wrong) {
  for (const std::string_view end : Texts{"", "\r"}) {
    Printer printer;
    printer.talk("-> G28\n<- ok\n-> G91\n<- ok");
    std::string line = numbered(1, "G1 X1 F6000", " ");
    line[line.find("X1") + 1] = '3';
    printer.send(line + std::string(end));
    bool asked = false;
    for (int i = 0; i < 3; ++i) {
      const auto answer = printer.reply(0.5);
      asked = asked || (answer && answer->starts_with("Resend: 1"));
    }
    EXPECT_TRUE(asked);
    printer.run(1);
    EXPECT_EQ(printer.chip.position[0], 0);
  }
}

}  // namespace
}  // namespace application_test
