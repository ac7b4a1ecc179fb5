// SPDX-License-Identifier: Apache-2.0
// M412, M603, M701 and M702: what is loaded, and what happens when filament runs out.
#include "tests/application/filament_printer.hpp"

namespace application_test {
namespace {

TEST_F(Filament, is_loaded_and_unloaded_while_the_host_sees_nothing_of_it) {
  talk("-> G1 E1 F300\n<- ok\n-> M701\n<- ok");
  EXPECT_DOUBLE_EQ(filament(), 56);
  talk("-> M114\n<* X:0.00 Y:0.00 Z:10.00 E:1.00 \n<- ok\n-> M702\n<- ok");
  EXPECT_DOUBLE_EQ(filament(), -4);
  talk("-> M701 L10\n<- ok");
  EXPECT_DOUBLE_EQ(filament(), 11);
  talk("-> M702 U3\n<- ok\n-> G1 E2\n<- ok\n-> M400\n<- ok");
  EXPECT_DOUBLE_EQ(filament(), 9);
}

TEST_F(Filament, is_loaded_with_its_speeds_above_the_part) {
  const auto began = printer.chip.time;
  printer.send("M701 Z5");
  printer.run(1.5);
  EXPECT_EQ(printer.chip.position[2], 15 * 2560);
  EXPECT_GT(filament(), 5);
  talk("<- ok");
  EXPECT_EQ(printer.chip.position[2], 10 * 2560);
  // 5 mm at 12 mm/s twice, 50 mm at 20 mm/s, 5 mm at 2 mm/s.
  EXPECT_NEAR(static_cast<double>(printer.chip.time - began) / clock_hz, 0.9 + 2.5 + 2.5, 0.5);
  talk(R"(
    -> M701 Z101
    <- echo:Move beyond the end of Z (0.00 to 110.00), not executed: "M701 Z101"
    <- ok
  )");
  EXPECT_DOUBLE_EQ(filament(), 55);
}

TEST_F(Filament, is_not_moved_cold) {
  talk("-> M302 S250\n<- ok");
  talk("-> M701\n<- echo:Hotend too cold, not executed: \"M701\"\n<- ok");
  talk("-> M702 Z2\n<- echo:Hotend too cold, not executed: \"M702 Z2\"\n<- ok");
  printer.run(1);
  EXPECT_DOUBLE_EQ(filament(), 0);
  EXPECT_EQ(printer.chip.position[2], 10 * 2560);
}

TEST_F(Filament, has_the_lengths_of_m603) {
  talk(R"(
    -> M603
    <- echo: M603 L50.00 U60.00
    <- ok
    -> M603 L20 U0
    <- ok
    -> M603
    <- echo: M603 L20.00 U0.00
    <- ok
    -> M603 L2001
    <- echo:L or U not within 0 to 2000 mm, not executed: "M603 L2001"
    <- ok
    -> M701
    <- ok
    -> M702
    <- ok
  )");
  EXPECT_DOUBLE_EQ(filament(), 25);
}

TEST_F(Filament, stops_moving_with_m410) {
  printer.send("M701");
  printer.run(1);
  talk("-> M410\n<- ok\n<- ok");
  const double there = filament();
  EXPECT_GT(there, 5);
  EXPECT_LT(there, 45);
  printer.run(1);
  EXPECT_DOUBLE_EQ(filament(), there);
  talk("-> M114\n<* X:0.00 Y:0.00 Z:10.00 E:0.00 \n<- ok\n-> G1 E1 F300\n<- ok\n-> M400\n<- ok");
  EXPECT_NEAR(filament(), there + 1, 0.003);
}

TEST_F(Filament, leaves_the_host_its_height_when_m410_stops_a_lifted_load) {
  printer.send("M701 Z5");
  printer.run(2);
  talk("-> M410\n<- ok\n<- ok");
  EXPECT_EQ(printer.chip.position[2], 15 * 2560);
  talk("-> M114\n<* Z:15.00 E:0.00 \n<- ok\n-> G1 Z10 F600\n<- ok\n-> M400\n<- ok");
  EXPECT_EQ(printer.chip.position[2], 10 * 2560);
  printer.send("M701 Z20");
  printer.run(0.5);
  talk("-> M410\n<- ok\n<- ok\n-> G1 Z12 F600\n<- ok\n-> M400\n<- ok");
  EXPECT_NEAR(printer.chip.position[2], 12 * 2560, 1);
}

TEST_F(Filament, asks_for_nothing_once_the_print_is_cancelled) {
  talk("-> M75\n<- ok");
  printer.chip.filament_is_out = true;
  talk("<- echo:Filament has run out\n<- //action:paused\n<* begin\n<* button\n<* show");
  printer.send("//action:cancel");
  while (printer.reply(0.5)) {
  }
  expect_silence();
  talk("-> M104 S0\n<- ok\n-> M75\n<- ok");
  talk("<- echo:Filament has run out\n<- //action:paused");
}

TEST_F(Filament, that_runs_out_in_a_print_is_changed_as_m600_does) {
  talk(R"(
    -> M75
    <- ok
    -> M119
    <- Reporting endstop status
    <- x_min: TRIGGERED
    <- y_min: TRIGGERED
    <- z_min: open
    <- filament: open
    <- ok
  )");
  printer.chip.filament_is_out = true;
  talk(R"(
    <- echo:Filament has run out
    <- //action:paused
    <- //action:prompt_begin Change the filament
    <- //action:prompt_button Continue
    <- //action:prompt_show
  )");
  printer.send("G1 X10 F6000");
  expect_silence();
  EXPECT_EQ(printer.chip.position[0], 0);
  printer.chip.filament_is_out = false;
  talk("-> M108\n<- //action:prompt_end\n<- //action:resumed\n<- ok\n<- ok\n-> M400\n<- ok");
  EXPECT_EQ(printer.chip.position[0], 10 * 80);
  expect_silence(3);
}

// Pulled out while the user changes it at the host's M600.
TEST_F(Filament, may_be_away_while_it_is_changed) {
  talk("-> M75\n<- ok\n-> M600\n<- //action:paused\n<* prompt_begin\n<* button\n<* show");
  printer.chip.filament_is_out = true;
  expect_silence();
  printer.chip.filament_is_out = false;
  talk("-> M108\n<- //action:prompt_end\n<- //action:resumed\n<- ok\n<- ok");
  expect_silence(3);
}

TEST_F(Filament, is_looked_at_in_a_print_only_and_while_m412_says_so) {
  printer.chip.filament_is_out = true;
  expect_silence();
  talk(R"(
    -> M412
    <- echo:Filament runout ON
    <- ok
    -> M412 S0
    <- ok
    -> M412
    <- echo:Filament runout OFF
    <- ok
    -> M75
    <- ok
  )");
  expect_silence();
  printer.send("M119");
  std::string last;
  while (const auto line = printer.reply()) {
    if (*line == "ok") break;
    last = *line;
  }
  EXPECT_EQ(last, "filament: TRIGGERED");
  talk("-> M412 S1\n<- ok\n<- echo:Filament has run out\n<- //action:paused");
}

// A contact that bounces is no end of filament.
TEST_F(Filament, is_there_though_a_contact_opens_for_a_moment) {
  talk("-> M75\n<- ok");
  for (int i = 0; i < 10; ++i) {
    printer.chip.filament_is_out = true;
    printer.run(0.1);
    printer.chip.filament_is_out = false;
    printer.run(0.1);
  }
  expect_silence();
}

TEST_F(Filament, has_settings_that_are_listed_and_restored) {
  talk("-> M412 S0\n<- ok\n-> M603 L20 U30\n<- ok");
  const std::string others =
      "<* M92\n<* M203\n<* M201\n<* M204\n<* M205\n<* M207\n<* M208\n<* M209\n";
  talk("-> M503\n" + others + "<- echo: M412 S0\n<- echo: M603 L20.00 U30.00\n<- ok");
  const std::string described = "<- echo: M412 S1\n<- echo: M603 L50.00 U60.00\n<- ok";
  talk("-> M501\n<* Hardcoded\n" + others + described);
  talk("-> M412 S0\n<- ok\n-> M603 L20 U30\n<- ok\n-> M502\n<* Hardcoded\n<- ok");
  talk("-> M503\n" + others + described);
}

TEST(filament_parts, are_answered_each_where_it_is_fitted) {
  application::MachineDescription machine = machine_under_test();
  machine.filament_sensor = &sensor;
  Printer printer(machine);
  printer.talk("-> M412\n<- echo:Filament runout ON\n<- ok");
  printer.talk("-> M603\n<- echo:M603 not fitted\n<- ok\n-> M701\n<- echo:M701 not fitted\n<- ok");
  machine.filament_sensor = nullptr;
  machine.filament_change = &change;
  Printer other(machine);
  other.talk("-> M412 S1\n<- echo:M412 not fitted\n<- ok\n-> M603\n<* L50.00 U60.00\n<- ok");
}

TEST(filament_parts, have_lengths_of_each_tool) {
  application::MachineDescription machine = described_machine("two_extruders");
  machine.filament_change = &change;
  Printer printer(machine);
  printer.talk(R"(
    -> M603 T1 L20 U30
    <- ok
    -> M603
    <- echo: M603 T0 L50.00 U60.00
    <- ok
    -> M603 T1
    <- echo: M603 T1 L20.00 U30.00
    <- ok
    -> M603 T2
    <- echo:M603 Invalid extruder 2
    <- ok
  )");
}

}  // namespace
}  // namespace application_test
