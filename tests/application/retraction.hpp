// SPDX-License-Identifier: Apache-2.0
// A homed and hot printer, and what its tests of G10 and G11 compare.
#pragma once

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>
#include <string_view>

#include "tests/application/dialogue.hpp"

namespace application_test {

inline constexpr std::size_t x = 0, z = 2, e = 3;
inline constexpr double step = 0.002;  // of E, the coarsest of those that are compared, in mm

class Retraction : public testing::Test {
 protected:
  // Homed, with a hot nozzle, at X10 Y10 Z5 E20.
  Retraction() {
    printer.chip.heaters[0].celsius = 200;
    talk("-> G28\n<- ok\n-> M104 S200\n<- ok\n-> G1 X10 Y10 Z5 E20 F6000\n<- ok\n");
  }
  void talk(std::string_view dialogue) { printer.talk(dialogue); }
  // Sends the lines, each of which is answered by nothing but ok, and waits for the end of motion.
  void execute(std::initializer_list<std::string_view> lines) {
    for (const std::string_view line : lines) {
      talk(std::string("-> ") + std::string(line) + "\n<- ok\n");
    }
    talk("-> M400\n<- ok\n");
  }
  void expect(double filament, double height) const {
    EXPECT_NEAR(printer.mm(e), filament, step);
    EXPECT_NEAR(printer.mm(z), height, step);
  }

  Printer printer;
};

}  // namespace application_test
