// SPDX-License-Identifier: Apache-2.0
// M999 after a fault.
#include <gtest/gtest.h>

#include "tests/application/dialogue.hpp"

namespace application_test {
namespace {

constexpr std::string_view halted = "<- Error:Printer halted. kill() called!\n";

class Restart : public testing::Test {
 protected:
  void kill() { printer.talk("-> M112\n" + std::string(halted)); }
  Printer printer;
};

TEST_F(Restart, restarts_after_m112) {
  printer.talk("-> M104 S200\n<- ok\n-> G1 X5 F600\n<- ok\n-> M400\n<- ok\n");
  kill();
  printer.talk("-> M999\n<- start\n");
  printer.run(3);
  EXPECT_EQ(printer.counters.halted, 0u);
  EXPECT_EQ(printer.chip.heater_duty(0), 0u);  // what was requested before is forgotten,
  EXPECT_NEAR(printer.mm(0), 5, 0.01);  // but not where the axes are
  printer.talk("-> G91\n<- ok\n-> G1 X2 F600\n<- ok\n-> M400\n<- ok\n");
  EXPECT_NEAR(printer.mm(0), 7, 0.01);
  printer.talk("-> M104 S200\n<- ok\n");
  printer.run(3);
  EXPECT_GT(printer.chip.heater_duty(0), 0u);
}

TEST_F(Restart, takes_m999_in_any_form) {
  for (const char* line : {"m999", "M999 S1", "M 0999 ; go on", "N7 M999*45"}) {
    kill();
    printer.send(line);
    EXPECT_EQ(printer.reply(5), "start") << line;
  }
}

TEST_F(Restart, takes_nothing_else) {
  kill();
  printer.run(2);
  for (const char* line :
       {"M99", "M9990", "G999", "XM999", "M999.1", "N7 M999*44", ";M999", "M998"}) {
    printer.send(line);
    EXPECT_EQ(printer.reply(5), "Error:Printer halted. kill() called!") << line;
    printer.run(1.5);
  }
  printer.send("M9");  // parts of a line that come one after another are one line
  printer.run(0.5);
  printer.send("99");
  EXPECT_EQ(printer.reply(2), "Error:Printer halted. kill() called!");
}

TEST_F(Restart, is_none_without_a_fault) {
  printer.talk("-> G1 X5 F600\n<- ok\n-> M999\n<- ok\n-> M400\n<- ok\n");
  EXPECT_NEAR(printer.mm(0), 5, 0.01);
}

TEST_F(Restart, halts_again_where_the_cause_persists) {
  const std::string fault =
      "<- Error:thermistor open, system stopped! Heater_ID: 0\n" + std::string(halted);
  printer.run(0.3);
  printer.talk("-> M104 S200\n<- ok\n");
  printer.run(5);
  printer.chip.heaters[0].open_sensor = true;
  printer.talk(fault);
  printer.talk("-> M999\n<- start\n-> M104 S200\n<- ok\n" + fault);
  EXPECT_EQ(printer.chip.heater_duty(0), 0u);
  printer.chip.heaters[0].open_sensor = false;
  printer.talk("-> M999\n<- start\n-> M104 S200\n<- ok\n");
  printer.run(5);
  EXPECT_EQ(printer.counters.halted, 0u);
  EXPECT_GT(printer.chip.heater_duty(0), 0u);
}

}  // namespace
}  // namespace application_test
