// SPDX-License-Identifier: Apache-2.0
// Heating, waiting, reporting, and every way in which heat ends the print.
#include <gtest/gtest.h>

#include <string>

#include "tests/application/dialogue.hpp"

namespace application_test {
namespace {

TEST(heat_commands, reports_temperatures_with_the_ok) {
  Printer printer;
  printer.run(0.3);
  printer.talk("-> M105\n<* ok T:2\n");
}

TEST(heat_commands, m109_reports_each_second_until_the_target_holds) {
  Printer printer;
  printer.run(0.3);
  printer.send("M109 S100");
  int reports = 0;
  for (;;) {
    const auto line = printer.reply();
    ASSERT_TRUE(line.has_value());
    if (*line == "ok") break;
    EXPECT_TRUE(line->starts_with(" T:")) << *line;
    EXPECT_NE(line->find(" W:"), std::string::npos) << *line;
    ++reports;
  }
  EXPECT_GT(reports, 20);
  EXPECT_NEAR(printer.chip.heaters[0].celsius, 100, 2);
  EXPECT_GT(printer.chip.watchdog_feeds, 100u);
  EXPECT_EQ(printer.chip.wrong_watchdog_feeds, 0u);
}

TEST(heat_commands, m109_s_does_not_wait_for_cooling) {
  Printer printer;
  printer.chip.heaters[0].celsius = 200;
  printer.run(0.3);
  printer.talk("-> M109 S100\n<- ok");
}

TEST(heat_commands, m108_ends_the_wait) {
  Printer printer;
  printer.run(0.3);
  printer.send("M190 S100");
  printer.run(2.5);
  printer.send("M108");
  std::string last;
  for (int oks = 0; oks < 2;) {
    const auto line = printer.reply(10);
    ASSERT_TRUE(line.has_value());
    oks += *line == "ok";
  }
  EXPECT_LT(printer.chip.heaters[1].celsius, 60);
}

// Targets and reports: of 205 °F, 96 °C are heated.
TEST(heat_commands, takes_temperatures_in_the_unit_of_m149) {
  Printer printer;
  printer.run(0.3);
  printer.talk(R"(
    -> M149 F
    <- ok
    -> M149
    <- echo: M149 F ; Units in Fahrenheit
    <- ok
    -> M104 S401
    <- ok
    -> M140 S140
    <- ok
    -> M105
    <* /205.00 B:
    -> M105
    <*  /60.00 
    -> M104 S205
    <- ok
    -> M105
    <* /96.11 B:
    -> M302 S338
    <- ok
    -> M302
    <- echo:Cold extrudes are disabled (min temp 170C)
    <- ok
    -> M149 K
    <- ok
    -> M104 S478.15
    <- ok
    -> M105
    <* /205.00 B:
    -> M149 C F K
    <- ok
    -> M149
    <- echo: M149 C ; Units in Celsius
    <- ok
    -> M104 S100
    <- ok
    -> M105
    <* /100.00 B:
  )");
  EXPECT_EQ(printer.counters.commands_refused, 0u);
}

TEST(heat_commands, refuses_what_is_too_hot_in_each_unit) {
  Printer printer;
  printer.run(0.3);
  for (const std::string unit : {"F", "K", "C"}) {
    printer.talk("-> M149 " + unit + "\n<- ok\n-> M104 S" +
                 (unit == "F"   ? "1000"
                  : unit == "K" ? "800"
                                : "500") +
                 "\n<* Above the highest target of \n<- ok\n-> M109 R999999999\n"
                 "<* Above the highest target of \n<- ok");
    EXPECT_EQ(printer.chip.heater_duty(0), 0u);
  }
  EXPECT_EQ(printer.counters.commands_refused, 6u);
}

TEST(heat_commands, switches_off_in_any_units) {
  Printer printer;
  printer.run(0.3);
  printer.talk("-> M104 S200\n<- ok\n-> M140 S50\n<- ok\n-> M149 F\n<- ok");
  printer.run(0.3);
  EXPECT_NE(printer.chip.heater_duty(0), 0u);
  printer.talk("-> M104 S0\n<- ok\n-> M190 S0\n<- ok");
  printer.run(0.3);
  EXPECT_EQ(printer.chip.heater_duty(0), 0u);
  EXPECT_EQ(printer.chip.heater_duty(1), 0u);
}

TEST(heat_commands, the_supply_is_closed_before_heat_is_asked_for_and_its_loss_is_a_fault) {
  Printer printer;
  printer.run(0.5);
  EXPECT_TRUE(printer.chip.supply_closed());
  printer.talk("-> M104 S200\n<- ok");
  printer.run(5);
  printer.chip.open_supply();
  printer.run(0.3);
  printer.talk("<- Error:Heater supply cut off\n<- Error:Printer halted. kill() called!");
  EXPECT_EQ(printer.chip.heater_duty(0), 0u);
  EXPECT_FALSE(printer.chip.supply_closed());
}

TEST(heat_commands, the_loss_of_the_supply_is_named_by_its_cause) {
  using Supply = registers::heater_control::Supply;
  struct Cause {
    bool Supply::* latched;
    const char* name;
  };
  for (const Cause& cause :
       {Cause{&Supply::veto_opened, "board's veto (clock watch)"},
        Cause{&Supply::watchdog_opened, "watchdog not fed"}, Cause{&Supply::trip_opened, "trip"},
        Cause{&Supply::emergency_stop_opened, "emergency stop"}}) {
    Printer printer;
    printer.run(0.5);
    printer.talk("-> M104 S200\n<- ok");
    printer.run(2);
    printer.chip.open_supply(cause.latched);
    printer.run(0.3);
    printer.talk(std::string("<- Error:Heater supply cut off: ") + cause.name +
                 "\n<- Error:Printer halted. kill() called!");
    EXPECT_EQ(printer.chip.heater_duty(0), 0u);
  }
}

TEST(heat_commands, a_supply_that_never_closes_is_no_failed_heating) {
  Printer printer;
  printer.chip.supply_refuses = true;
  printer.run(5);
  printer.talk(R"(
    -> M104 S200
    <- ok
    <- Error:Heater supply does not close
    <- Error:Printer halted. kill() called!
  )");
}

TEST(heat_commands, a_broken_thermistor_ends_everything) {
  Printer printer;
  printer.run(0.3);
  printer.talk("-> M104 S200\n<- ok");
  printer.run(5);
  printer.chip.heaters[0].open_sensor = true;
  printer.talk(R"(
    <- Error:thermistor open, system stopped! Heater_ID: 0
    <- Error:Printer halted. kill() called!
  )");
  EXPECT_EQ(printer.chip.heater_duty(0), 0u);
  EXPECT_EQ(printer.chip.motors, 0u);
}

TEST(heat_commands, a_heater_without_effect_is_a_failed_heating) {
  Printer printer;
  printer.chip.heaters[1].celsius_per_second_at_full_power = 0;
  printer.run(0.3);
  printer.talk(R"(
    -> M140 S60
    <- ok
    <- Error:Heating failed, system stopped! Heater_ID: bed
    <- Error:Printer halted. kill() called!
  )");
}

TEST(heat_commands, a_gate_closed_by_the_hardware_ends_everything) {
  Printer printer;
  printer.run(0.3);
  printer.talk("-> M104 S200\n<- ok");
  printer.run(2);
  printer.chip.heaters[0].tripped = true;
  printer.talk("<* Heater_ID: 0\n<- Error:Printer halted. kill() called!");
}

TEST(heat_commands, after_m112_lines_get_the_fault_and_never_an_ok) {
  Printer printer;
  printer.run(0.3);
  printer.talk("-> M104 S200\n<- ok\n-> M112\n<- Error:Printer halted. kill() called!");
  EXPECT_EQ(printer.chip.heater_duty(0), 0u);
  printer.send("M105");
  EXPECT_EQ(printer.reply(5), "Error:Printer halted. kill() called!");
  printer.send("G1 X10");
  printer.run(3);
  EXPECT_EQ(printer.chip.from_firmware.find("ok"), std::string::npos);
  EXPECT_EQ(printer.counters.halted, 1u);
}

TEST(heat_commands, reports_by_itself_after_m155) {
  Printer printer;
  printer.run(0.3);
  printer.talk("-> M155 S2\n<- ok\n<*  T:2\n<*  T:2\n-> M155 S0\n<- ok");
  EXPECT_FALSE(printer.reply(6).has_value());
}

TEST(heat_commands, sets_the_fan_from_0_to_255) {
  Printer printer;
  printer.talk("-> M106 S244.8\n<- ok");
  EXPECT_EQ(printer.chip.fan_duty, 244u);
  printer.talk("-> M106 S999\n<- ok");
  EXPECT_EQ(printer.chip.fan_duty, 255u);
  printer.talk("-> M107\n<- ok");
  EXPECT_EQ(printer.chip.fan_duty, 0u);
  printer.talk("-> M106\n<- ok");
  EXPECT_EQ(printer.chip.fan_duty, 255u);
}

TEST(heat_commands, a_target_too_high_is_refused_and_changes_nothing) {
  Printer printer;
  printer.run(0.3);
  printer.talk(R"(
    -> M104 S260
    <- ok
    -> M104 S260.01
    <- echo:Above the highest target of 260.00, not executed: "M104 S260.01"
    <- ok
    -> M109 S999
    <- echo:Above the highest target of 260.00, not executed: "M109 S999"
    <- ok
    -> M190 R106
    <- echo:Above the highest target of 105.00, not executed: "M190 R106"
    <- ok
    -> M140 S109
    <- echo:Above the highest target of 105.00, not executed: "M140 S109"
    <- ok
    -> M105
    <* /260.00 B:25.00 /0.00
  )");
}

}  // namespace
}  // namespace application_test
