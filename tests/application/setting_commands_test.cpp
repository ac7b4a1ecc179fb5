// SPDX-License-Identifier: Apache-2.0
// Settings: accepted values, refused values, and reports without values.
#include <gtest/gtest.h>

#include "tests/application/dialogue.hpp"

namespace application_test {
namespace {

// M503 of what the machine description says.
const std::string described_settings = R"(
    <- echo: M92 X80.00 Y80.00 Z2560.00 E500.00
    <- echo: M203 X200.00 Y200.00 Z12.00 E80.00
    <- echo: M201 X3000.00 Y3000.00 Z500.00 E10000.00
    <- echo: M204 P1500.00 R1500.00 T1500.00
    <- echo: M205 S0.00 T0.00 X10.00 Y10.00 Z0.40 E2.50
    <- echo: M207 S3.00 F2700.00 Z0.00
    <- echo: M208 S0.00 F480.00
    <- echo: M209 S0
    <- ok
)";

TEST(setting_commands, take_what_sliced_files_begin_with) {
  Printer printer;
  printer.talk(R"(
    -> M201 X500 Y500 Z100 E5000
    <- ok
    -> M203 X500 Y500 Z10 E60
    <- ok
    -> M204 P500 R1000 T500
    <- ok
    -> M205 X8.00 Y8.00 Z0.40 E5.00
    <- ok
    -> M205 S0 T0
    <- ok
  )");
  EXPECT_EQ(printer.counters.commands_refused, 0u);
}

TEST(setting_commands, refuse_values_that_cannot_be) {
  Printer printer;
  printer.talk("-> M201 X0\n<* not executed\n<- ok\n-> M203 Y-5\n<* not executed\n<- ok");
  EXPECT_EQ(printer.counters.commands_refused, 2u);
}

// A line with any wrong value has no effect.
TEST(setting_commands, keep_what_was_where_one_value_of_a_line_is_refused) {
  Printer printer;
  for (const char* line :
       {"M205 X5 S-1", "M205 X5 J-0.1", "M205 J1.1 X5", "M205 X-1 S5", "M205 Z5 T-1",
        "M204 P500 T-1", "M204 R500 P0", "M201 X500 Y0", "M203 E20 X-1", "M92 X100 Y0"}) {
    printer.send(line);
    const auto said = printer.reply();
    ASSERT_TRUE(said.has_value());
    EXPECT_TRUE(said->contains("not executed")) << line << ": " << *said;
    EXPECT_EQ(printer.reply(), "ok");
  }
  printer.talk("-> M503\n" + described_settings);
}

TEST(setting_commands, m92_changes_the_steps_of_later_moves) {
  Printer printer;
  printer.talk(R"(
    -> G28
    <- ok
    -> M92
    <- echo: M92 X80.00 Y80.00 Z2560.00 E500.00
    <- ok
    -> M92 X100
    <- ok
    -> G1 X10 F3000
    <- ok
    -> M400
    <- ok
  )");
  EXPECT_EQ(printer.chip.position[0], 1000);
}

TEST(setting_commands, m113_reports_and_sets_the_busy_interval) {
  Printer printer;
  printer.talk(
      "-> M113\n<- echo:M113 S2\n<- ok\n-> M113 S5\n<- ok\n-> M113\n<- echo:M113 S5\n<- ok");
}

TEST(setting_commands, without_values_report_what_holds) {
  Printer printer;
  printer.talk(R"(
    -> M201
    <- echo: M201 X3000.00 Y3000.00 Z500.00 E10000.00
    <- ok
    -> M203
    <- echo: M203 X200.00 Y200.00 Z12.00 E80.00
    <- ok
    -> M204
    <- echo: M204 P1500.00 R1500.00 T1500.00
    <- ok
    -> M205
    <- echo: M205 S0.00 T0.00 X10.00 Y10.00 Z0.40 E2.50
    <- ok
    -> M204 P800 T1234.5
    <- ok
    -> M204
    <- echo: M204 P800.00 R1500.00 T1234.50
    <- ok
    -> M205 B20000 J0.02
    <- ok
    -> M205
    <- echo: M205 S0.00 T0.00 J0.020000 X10.00 Y10.00 Z0.40 E2.50
    <- ok
    -> M205 J0
    <- ok
    -> M205
    <- echo: M205 S0.00 T0.00 X10.00 Y10.00 Z0.40 E2.50
    <- ok
  )");
  EXPECT_EQ(printer.counters.commands_refused, 0u);
}

TEST(setting_commands, m503_lists_all_in_the_form_that_sets_them) {
  Printer printer;
  printer.talk(R"(
    -> M203 X150 E42.25
    <- ok
    -> M503
    <- echo: M92 X80.00 Y80.00 Z2560.00 E500.00
    <- echo: M203 X150.00 Y200.00 Z12.00 E42.25
    <- echo: M201 X3000.00 Y3000.00 Z500.00 E10000.00
    <- echo: M204 P1500.00 R1500.00 T1500.00
    <- echo: M205 S0.00 T0.00 X10.00 Y10.00 Z0.40 E2.50
    <- echo: M207 S3.00 F2700.00 Z0.00
    <- echo: M208 S0.00 F480.00
    <- echo: M209 S0
    <- ok
  )");
}

// So its lines set the same again.
TEST(setting_commands, reports_in_inches_after_g20) {
  Printer printer;
  printer.talk(R"(
    -> M203 X254
    <- ok
    -> G20
    <- ok
    -> M203
    <- echo: M203 X10.000 Y7.874 Z0.472 E3.150
    <- ok
    -> M203 X20
    <- ok
    -> M205 J0.01
    <- ok
    -> M503
    <- echo: G20 ; Units in inches
    <- echo: M92 X80.00 Y80.00 Z2560.00 E500.00
    <- echo: M203 X20.000 Y7.874 Z0.472 E3.150
    <- echo: M201 X118.110 Y118.110 Z19.685 E393.701
    <- echo: M204 P59.055 R59.055 T59.055
    <- echo: M205 S0.000 T0.000 J0.010000 X0.394 Y0.394 Z0.016 E0.098
    <- echo: M207 S0.118 F106.299 Z0.000
    <- echo: M208 S0.000 F18.898
    <- echo: M209 S0
    <- ok
    -> G21
    <- ok
    -> M203
    <- echo: M203 X508.00 Y200.00 Z12.00 E80.00
    <- ok
  )");
}

// While it moves it waits for the end: the steps of the move are those that it began with.
TEST(setting_commands, m502_restores_what_the_machine_description_says) {
  Printer printer;
  printer.talk(R"(
    -> G28
    <- ok
    -> M92 X100
    <- ok
    -> M203 X100
    <- ok
    -> M204 T700
    <- ok
    -> G1 X10 F3000
    <- ok
    -> M502
    <- echo:Hardcoded Default Settings Loaded
    <- ok
  )");
  EXPECT_EQ(printer.mm(0), 10);
  EXPECT_EQ(printer.chip.position[0], 800);
  printer.talk(R"(
    -> M203 Y100
    <- ok
    -> M501
    <- echo:Hardcoded Default Settings Loaded
)" + described_settings +
               R"(
    -> G1 X20
    <- ok
    -> M400
    <- ok
  )");
  EXPECT_EQ(printer.chip.position[0], 1600);
}

TEST(setting_commands, m211_opens_and_closes_the_limits_of_the_travel) {
  Printer printer;
  printer.talk(R"(
    -> G28
    <- ok
    -> M211
    <- echo:Soft endstops: ON  Min: X0.00 Y0.00 Z0.00  Max: X200.00 Y200.00 Z110.00
    <- ok
    -> G1 X-1 F6000
    <* Move beyond the end of X
    <- ok
    -> M211 S2
    <- echo:S not within 0 to 1, not executed: "M211 S2"
    <- ok
    -> G1 X-1
    <* Move beyond the end of X
    <- ok
    -> M211 S0
    <- ok
    -> G1 X-1
    <- ok
    -> M400
    <- ok
  )");
  EXPECT_EQ(printer.chip.position[0], -80);
  printer.talk(R"(
    -> M211
    <* Soft endstops: OFF
    <- ok
    -> M211 S1
    <- ok
    -> G1 X-2
    <* Move beyond the end of X
    <- ok
    -> G2 X4 Y0 I2.5
    <* Move beyond
    <- ok
  )");
}

TEST(progress, is_what_the_host_has_said) {
  Printer printer;
  printer.talk(R"(
    -> M73
    <- echo: M73 Progress: 0%; Time left: 0m;
    <- ok
    -> M73 P25 R12
    <- ok
    -> M73 P130
    <- ok
    -> M73
    <- echo: M73 Progress: 100%; Time left: 12m;
    <- ok
  )");
}

}  // namespace
}  // namespace application_test
