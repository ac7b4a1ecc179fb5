// SPDX-License-Identifier: Apache-2.0
// Queries that hosts send before and during a print.
#include <gtest/gtest.h>

#include "tests/application/dialogue.hpp"

namespace application_test {
namespace {

TEST(report_commands, reports_what_it_is_and_can) {
  Printer printer;
  printer.send("M115");
  const auto first = printer.reply();
  ASSERT_TRUE(first.has_value());
  EXPECT_TRUE(first->starts_with("FIRMWARE_NAME:StepFabric")) << *first;
  bool autoreport = false;
  for (;;) {
    const auto line = printer.reply();
    ASSERT_TRUE(line.has_value());
    if (*line == "ok") break;
    EXPECT_TRUE(line->starts_with("Cap:")) << *line;
    autoreport |= *line == "Cap:AUTOREPORT_TEMP:1";
  }
  EXPECT_TRUE(autoreport);
}

TEST(report_commands, reports_which_end_stops_are_triggered) {
  Printer printer;
  printer.chip.mechanical[1] = 0;
  printer.talk(R"(
    -> M119
    <- Reporting endstop status
    <- x_min: open
    <- y_min: TRIGGERED
    <- z_min: open
    <- ok
  )");
}

// In Marlin's words, by which OctoPrint knows it; the print goes on with the tool that there is.
TEST(report_commands, refuses_a_tool_that_is_not_there_aloud) {
  Printer printer;
  printer.talk(R"(
    -> T2
    <- echo:T2 Invalid extruder
    <- ok
    -> M104 T1 S200
    <- echo:M104 Invalid extruder 1
    <- ok
    -> T0
    <- ok
  )");
  EXPECT_EQ(printer.counters.commands_refused, 2u);
  EXPECT_EQ(printer.chip.heater_duty(0), 0u);
}

TEST(report_commands, reports_no_temperature_before_there_is_one) {
  Printer printer;
  printer.send("M105");
  const auto answer = printer.reply();
  ASSERT_TRUE(answer.has_value());
  EXPECT_TRUE(answer->starts_with("ok T:25.")) << *answer;
}

TEST(report_commands, reports_none_by_itself_before_there_is_one) {
  Printer printer;
  printer.send("M155 S1");
  printer.run(3);
  const std::string& said = printer.chip.from_firmware;
  EXPECT_NE(said.find(" T:25."), std::string::npos) << said;
  EXPECT_EQ(said.find("T:0."), std::string::npos) << said;
  EXPECT_EQ(said.find("B:0."), std::string::npos) << said;
}

// A host that comes while the user is waited for, right after a reset.
TEST(report_commands, reports_none_ahead_of_the_queue_before_there_is_one) {
  Printer printer;
  printer.send("M0");
  printer.run(0.01);
  printer.send("M105");
  printer.run(3);
  const std::string& said = printer.chip.from_firmware;
  EXPECT_NE(said.find("ok T:25."), std::string::npos) << said;
  EXPECT_EQ(said.find("T:0."), std::string::npos) << said;
}

TEST(report_commands, ends_its_name_where_octoprint_and_cura_do) {
  Printer printer;
  printer.send("M115");
  const auto line = printer.reply();
  ASSERT_TRUE(line.has_value());
  // OctoPrint takes what stands before the next key, Cura what stands before the last semicolon.
  EXPECT_TRUE(line->starts_with("FIRMWARE_NAME:StepFabric PROTOCOL_VERSION:")) << *line;
  EXPECT_TRUE(line->contains(';')) << *line;
}

TEST(report_commands, reports_positions_by_itself_after_m154) {
  Printer printer;
  printer.talk(R"(
    -> M154 S1
    <- ok
    <* X:0.00 Y:0.00 Z:0.00 E:0.00 Count
    <* X:0.00 Y:0.00 Z:0.00 E:0.00 Count
    -> M154 S0
    <- ok
  )");
  EXPECT_FALSE(printer.reply(3).has_value());
}

}  // namespace
}  // namespace application_test
