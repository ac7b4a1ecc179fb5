// SPDX-License-Identifier: Apache-2.0
// A homed printer with a hot nozzle, for tests that look where the axes go.
#pragma once

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>
#include <string_view>

#include "tests/application/dialogue.hpp"

namespace application_test {

class HomedPrinter : public testing::Test {
 protected:
  static constexpr std::size_t x = 0, y = 1, z = 2, e = 3;
  static constexpr double step = 0.002;  // of E, the coarsest of those that are compared, in mm

  HomedPrinter() {
    printer.chip.heaters[0].celsius = 200;
    execute({"G28", "M104 S200"});
  }
  // Sends the lines, each of which is answered by nothing but ok, and waits for the end of motion.
  void execute(std::initializer_list<std::string_view> lines) {
    for (const std::string_view line : lines) printer.talk("-> " + std::string(line) + "\n<- ok\n");
    printer.talk("-> M400\n<- ok\n");
  }
  void expect(double at_x, double at_y, double at_z) const {
    EXPECT_NEAR(printer.mm(x), at_x, step);
    EXPECT_NEAR(printer.mm(y), at_y, step);
    EXPECT_NEAR(printer.mm(z), at_z, step);
  }

  Printer printer;
};

}  // namespace application_test
