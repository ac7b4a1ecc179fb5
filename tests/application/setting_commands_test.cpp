// SPDX-License-Identifier: Apache-2.0
// Settings: accepted values, refused values, and reports without values.
#include <gtest/gtest.h>

#include "tests/application/dialogue.hpp"

namespace application_test {
namespace {

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
  printer.talk(R"(
    -> M503
    <- echo: M92 X80.00 Y80.00 Z2560.00 E500.00
    <- echo: M203 X200.00 Y200.00 Z12.00 E80.00
    <- echo: M201 X3000.00 Y3000.00 Z500.00 E10000.00
    <- echo: M204 P1500.00 R1500.00 T1500.00
    <- echo: M205 S0.00 T0.00 X10.00 Y10.00 Z0.40 E2.50
    <- ok
  )");
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
    <- ok
  )");
}

}  // namespace
}  // namespace application_test
