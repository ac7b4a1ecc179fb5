// SPDX-License-Identifier: Apache-2.0
// Input shaping and linear advance from the line to the step counters.
#include <gtest/gtest.h>

#include "tests/application/dialogue.hpp"

namespace application_test {
namespace {

application::MachineDescription shaped_machine(const motion::ShapingSettings& settings = {}) {
  application::MachineDescription machine = machine_under_test();
  machine.shaping = settings;
  return machine;
}

TEST(shaping_commands, set_and_report_shapers) {
  Printer printer(shaped_machine());
  printer.talk(R"(
    -> M593
    <- echo: M593 X P"none"
    <- echo: M593 Y P"none"
    <- ok
    -> M593 F42.5 D0.15 ; Marlin
    <- ok
    -> M593
    <- echo: M593 X P"zv" F42.50 D0.1500
    <- echo: M593 Y P"zv" F42.50 D0.1500
    <- ok
    -> M593 P"MZV" F38 S0.08 ; RepRapFirmware
    <- ok
    -> M593 Y P"2hump_ei" F61.25
    <- ok
    -> M593
    <- echo: M593 X P"mzv" F38.00 D0.0800
    <- echo: M593 Y P"2hump_ei" F61.25 D0.0800
    <- ok
    -> M593 X F0
    <- ok
    -> M593 Y P"ei2"
    <- ok
    -> M593
    <- echo: M593 X P"none"
    <- echo: M593 Y P"2hump_ei" F61.25 D0.0800
    <- ok
  )");
  EXPECT_EQ(printer.counters.commands_refused, 0u);
}

TEST(shaping_commands, refuse_what_is_out_of_range_and_change_nothing) {
  Printer printer(shaped_machine());
  printer.talk(R"(
    -> M593 F40
    <- ok
    -> M593 P"custom" F30
    <* P is none of none, zv, zvd, mzv, ei, 2hump_ei
    <- ok
    -> M593 X F30 D0.95
    <* D not within 0 to 0.9
    <- ok
    -> M593 Y F30 D-0.1
    <* D not within 0 to 0.9
    <- ok
    -> M593 F2
    <* F is too high or too low
    <- ok
    -> M593 F400
    <* F is too high or too low
    <- ok
    -> M593
    <- echo: M593 X P"zv" F40.00 D0.1000
    <- echo: M593 Y P"zv" F40.00 D0.1000
    <- ok
    -> M900 K11
    <* K not within 0 to 10
    <- ok
    -> M900 K-1
    <* K not within 0 to 10
    <- ok
    -> M900
    <- echo: M900 K0.0000
    <- ok
  )");
}

TEST(shaping_commands, set_and_report_linear_advance) {
  Printer printer(shaped_machine());
  printer.talk(R"(
    -> M900 K0.055
    <- ok
    -> M900
    <- echo: M900 K0.0550
    <- ok
    -> M572 D0 S0.2
    <- ok
    -> M572
    <- echo: M900 K0.2000
    <- ok
    -> M900 K0
    <- ok
    -> M572
    <- echo: M900 K0.0000
    <- ok
  )");
}

TEST(shaping_commands, are_listed_and_restored_with_the_settings) {
  motion::ShapingSettings settings;
  settings.shapers[0] = {.type = motion::ShaperType::ei, .millihertz = 50'000, .damping = 500};
  settings.advance_microseconds = 40'000;
  Printer printer(shaped_machine(settings));
  const auto listed = [&printer] {
    printer.send("M503");
    std::string all;
    while (const auto line = printer.reply()) {
      if (*line == "ok") break;
      if (line->starts_with("echo: M593") || line->starts_with("echo: M900")) all += *line + "|";
    }
    return all;
  };
  const std::string defaults =
      "echo: M593 X P\"ei\" F50.00 D0.0500|echo: M593 Y P\"none\"|echo: M900 K0.0400|";
  EXPECT_EQ(listed(), defaults);
  printer.talk("-> M593 P\"none\"\n<- ok\n-> M900 K0\n<- ok");
  EXPECT_NE(listed(), defaults);
  printer.talk("-> M502\n<- echo:Hardcoded Default Settings Loaded\n<- ok");
  EXPECT_EQ(listed(), defaults);
}

TEST(shaping_commands, say_so_where_the_default_does_not_fit_the_clock) {
  motion::ShapingSettings settings;
  settings.shapers[1] = {.type = motion::ShaperType::zv, .millihertz = 120'000, .damping = 500};
  Printer printer(shaped_machine(settings));
  EXPECT_EQ(printer.reply(), "echo:Input shaping off: its frequency does not fit this clock");
}

// M400 waits for the last impulse, and then every axis is where it is without shaping.
TEST(shaping_commands, end_each_motion_at_its_step) {
  Printer printer(shaped_machine());
  printer.chip.heaters[0].celsius = 205;
  printer.talk(R"(
    -> M302 P1
    <- ok
    -> M593 X P"zvd" F40
    <- ok
    -> M593 Y P"2hump_ei" F30
    <- ok
    -> M900 K0.1
    <- ok
    -> G1 X10 Y5 E2 F3000
    <- ok
    -> G1 X-3.3 Y7 Z0.2 E3
    <- ok
    -> G1 E1 F1800
    <- ok
    -> G1 X4 Y4 E1.5
    <- ok
    -> M400
    <- ok
  )");
  EXPECT_NEAR(printer.mm(0), 4, 0.01);
  EXPECT_NEAR(printer.mm(1), 4, 0.01);
  EXPECT_NEAR(printer.mm(2), 0.2, 0.001);
  EXPECT_NEAR(printer.mm(3), 1.5, 0.002);
  EXPECT_EQ(printer.chip.underruns, 0u);
  // From rest again, with a change in between that comes while the axes move.
  printer.talk(R"(
    -> G1 X20 E2.5 F3000
    <- ok
    -> M900 K0.02
    <- ok
    -> G1 X0 Y0
    <- ok
    -> M400
    <- ok
    -> M900
    <- echo: M900 K0.0200
    <- ok
  )");
  EXPECT_NEAR(printer.mm(0), 0, 0.01);
  EXPECT_NEAR(printer.mm(1), 0, 0.01);
  EXPECT_NEAR(printer.mm(3), 2.5, 0.002);
  EXPECT_EQ(printer.chip.underruns, 0u);
}

TEST(shaping_commands, leave_homing_as_it_is) {
  Printer plain;
  Printer shaped(shaped_machine());
  (void)plain;
  shaped.talk(R"(
    -> M593 F40 P"zvd"
    <- ok
    -> G1 X3 Y3 F3000
    <- ok
    -> G28
    <- ok
    -> G1 X30 Y20 F6000
    <- ok
    -> M400
    <- ok
  )");
  EXPECT_NEAR(shaped.mm(0), 30, 0.02);
  EXPECT_NEAR(shaped.mm(1), 20, 0.02);
  EXPECT_NEAR(static_cast<double>(shaped.chip.mechanical[0]), shaped.mm(0) * 80, 40);
  EXPECT_EQ(shaped.chip.underruns, 0u);
}

TEST(shaping_commands, begin_from_rest_after_a_quick_stop) {
  Printer printer(shaped_machine());
  printer.talk("-> M593 F40 P\"ei\"\n<- ok\n-> G1 X60 F3000\n<- ok");
  printer.run(0.5);
  printer.talk("-> M410\n<- ok");
  const double stopped_at = printer.mm(0);
  EXPECT_GT(stopped_at, 5);
  EXPECT_LT(stopped_at, 40);
  printer.run(0.5);
  EXPECT_EQ(printer.mm(0), stopped_at);
  printer.talk("-> G1 X10 F3000\n<- ok\n-> M400\n<- ok");
  EXPECT_NEAR(printer.mm(0), 10, 0.02);
  EXPECT_EQ(printer.chip.underruns, 0u);
}

}  // namespace
}  // namespace application_test
