// SPDX-License-Identifier: Apache-2.0
// Two hotends and a bed: each by itself, and all protected alike.
#include "tests/application/two_tools.hpp"

namespace application_test {
namespace {

TEST(two_hotends, are_heated_each_by_itself) {
  Printer printer(machine_with_two_tools());
  printer.run(1);
  printer.talk("-> M104 S210 T1\n<- ok");
  printer.run(5);
  EXPECT_EQ(printer.chip.heater_duty(0), 0u);
  EXPECT_EQ(printer.chip.heater_duty(1), 0u);
  EXPECT_GT(printer.chip.heater_duty(2), 0u);
  printer.talk("-> M105\n<* /0.00 B:25.00 /0.00 T0:25.00 /0.00 T1:");
  printer.talk("-> M104 S0 T1\n<- ok\n-> M104 S190\n<- ok");
  printer.run(1);
  EXPECT_GT(printer.chip.heater_duty(0), 0u);
  EXPECT_EQ(printer.chip.heater_duty(2), 0u);
}

TEST(two_hotends, are_reported_in_marlins_form) {
  Printer printer(machine_with_two_tools());
  printer.chip.heaters[2].celsius = 60.5;
  printer.run(1);
  const auto report = [&printer] {
    printer.send("M105");
    std::string line = printer.reply().value_or("");
    // Hundredths of a degree are those of the thermistor's table.
    for (std::size_t dot = line.find('.'); dot != std::string::npos; dot = line.find('.', dot)) {
      line.erase(dot, 3);
    }
    return line;
  };
  EXPECT_EQ(report(), "ok T:25 /0 B:25 /0 T0:25 /0 T1:60 /0 @:0 B@:0 @0:0 @1:0");
  printer.talk("-> T1\n<- ok");
  EXPECT_EQ(report(), "ok T:60 /0 B:25 /0 T0:25 /0 T1:60 /0 @:0 B@:0 @0:0 @1:0");
  printer.talk("-> M155 S1\n<- ok\n<*  T:\n-> M155 S0\n<- ok");
}

TEST(two_hotends, are_waited_for_by_their_number) {
  Printer printer(machine_with_two_tools());
  printer.run(1);
  printer.send("M109 S60 T1");
  std::optional<std::string> line = printer.reply();
  for (int i = 0; i < 200 && line && *line != "ok"; ++i) {
    EXPECT_TRUE(line->contains(" T1:")) << *line;
    line = printer.reply();
  }
  EXPECT_EQ(line, "ok");
  EXPECT_NEAR(printer.chip.heaters[2].celsius, 60, 2);
  EXPECT_LT(printer.chip.heaters[0].celsius, 26);
}

TEST(two_hotends, that_are_not_there_are_refused) {
  Printer two(machine_with_two_tools());
  two.talk("-> M104 S200 T2\n<- echo:M104 Invalid extruder 2\n<- ok");
  two.talk("-> M109 S200 T2\n<- echo:M109 Invalid extruder 2\n<- ok");
  Printer one;
  one.talk("-> M104 S200 T1\n<- echo:M104 Invalid extruder 1\n<- ok");
  one.talk("-> M109 S200 T1\n<- echo:M109 Invalid extruder 1\n<- ok");
  one.run(2);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    EXPECT_EQ(one.chip.heater_duty(channel), 0u);
  }
}

TEST_F(TwoTools, keep_the_target_of_the_one_that_rests) {
  execute({"G1 X100 Y50 Z10 F6000", "T1"});
  printer.run(20);
  EXPECT_GT(printer.chip.heater_duty(0), 0u);
  EXPECT_NEAR(printer.chip.heaters[0].celsius, 200, 3);
  printer.talk("-> M105\n<* /200.00 B:");
  execute({"M104 S0"});  // of the tool in use
  printer.run(1);
  EXPECT_GT(printer.chip.heater_duty(0), 0u);
  EXPECT_EQ(printer.chip.heater_duty(2), 0u);
}

TEST_F(TwoTools, do_not_extrude_while_their_own_hotend_is_cold) {
  execute({"G1 X100 Y50 Z10 F6000", "M104 S0 T1"});
  printer.chip.heaters[2].celsius = 40;
  printer.run(3);
  execute({"G1 E1 F300", "T1"});
  printer.talk("-> G1 E2\n<- echo: cold extrusion prevented\n<- ok");
  execute({"T0", "G1 E3"});
  expect_steps(100, 50, 10, 2, 0);
}

// As a fault of the first: everything off, and its number in the message.
TEST(second_hotend, with_an_open_sensor_halts_the_printer) {
  Printer printer(machine_with_two_tools());
  printer.run(1);
  printer.talk("-> M104 S200 T0\n<- ok\n-> M104 S200 T1\n<- ok\n-> M140 S60\n<- ok");
  printer.run(3);
  printer.chip.heaters[2].open_sensor = true;
  printer.talk("<* Heater_ID: 1\n<* kill() called");
  for (std::size_t channel = 0; channel < 3; ++channel) {
    EXPECT_EQ(printer.chip.heater_duty(channel), 0u);
  }
  EXPECT_FALSE(printer.chip.supply_closed());
}

TEST(second_hotend, that_does_not_become_warm_halts_the_printer) {
  Printer printer(machine_with_two_tools());
  printer.run(1);
  printer.chip.heaters[2].celsius_per_second_at_full_power = 0;
  printer.talk("-> M104 S200 T1\n<- ok\n<* Heater_ID: 1\n<* kill() called");
  EXPECT_EQ(printer.chip.heater_duty(2), 0u);
}

TEST(second_hotend, that_runs_away_while_it_rests_halts_the_printer) {
  Printer printer(machine_with_two_tools());
  printer.chip.heaters[2].celsius = 200;
  printer.run(1);
  printer.talk("-> M104 S200 T1\n<- ok");
  printer.run(60);
  printer.chip.heaters[2].loss_per_second = 0.05;  // the bead has slipped out
  printer.talk("<* Heater_ID: 1\n<* kill() called");
}

TEST(second_hotend, is_cut_off_by_the_hardware_as_the_first) {
  Printer printer(machine_with_two_tools());
  printer.run(1);
  printer.talk("-> M104 S200 T1\n<- ok");
  printer.run(2);
  printer.chip.heaters[2].tripped = true;
  printer.talk("<* system stopped! Heater_ID: 1\n<* kill() called");
}

// It is off too when the host is gone.
TEST(second_hotend, is_switched_off_with_a_silent_host) {
  Printer printer(machine_with_two_tools());
  printer.run(1);
  printer.talk("-> M86 S20\n<- ok\n-> M104 S60 T1\n<- ok\n<* heaters off");
  printer.run(1);
  EXPECT_EQ(printer.chip.heater_duty(2), 0u);
}

}  // namespace
}  // namespace application_test
