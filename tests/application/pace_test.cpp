// SPDX-License-Identifier: Apache-2.0
// M220 and pauses act on the move under way, and leave where it goes as it is.
#include <gtest/gtest.h>

#include "drivers/registers/step_generator_registers.hpp"
#include "tests/application/dialogue.hpp"

namespace application_test {
namespace {

constexpr std::size_t x = 0;

// On its way to 100 mm at 10 mm/s for about a second.
void set_out(Printer& printer) {
  printer.talk("-> G28\n<- ok\n-> G1 X100 F600\n<- ok");
  printer.run(1.1);
}

TEST(pace, m220_below_100_slows_the_move_under_way) {
  Printer printer;
  set_out(printer);
  const double before = printer.mm(x);
  printer.talk("-> M220 S50\n<- ok");
  printer.run(4);
  EXPECT_NEAR(printer.mm(x) - before, 20, 0.5);
  printer.talk("-> M220\n<- FR:50%\n<- ok\n-> M220 S100\n<- ok");
  const double faster_from = printer.mm(x);
  printer.run(4);
  EXPECT_NEAR(printer.mm(x) - faster_from, 40, 0.5);
  printer.talk("-> M400\n<- ok");
  EXPECT_EQ(printer.chip.position[x], 8000);
}

TEST(pace, m220_above_100_leaves_the_move_under_way_and_plans_the_next_faster) {
  Printer printer;
  set_out(printer);
  const double before = printer.mm(x);
  printer.talk("-> M220 S300\n<- ok");
  printer.run(2);
  EXPECT_NEAR(printer.mm(x) - before, 20, 0.5);
  printer.talk("-> M400\n<- ok\n-> G1 X0\n<- ok");
  printer.run(2);
  EXPECT_NEAR(printer.mm(x), 40, 2);
}

TEST(pace, a_line_that_comes_after_m220_is_not_slowed_twice) {
  Printer printer;
  printer.talk("-> G28\n<- ok\n-> M220 S50\n<- ok\n-> G1 X100 F1200\n<- ok");
  printer.run(5);
  EXPECT_NEAR(printer.mm(x), 50, 2);
}

TEST(pace, many_lines_at_a_tenth_of_their_speed_come_without_an_underrun) {
  Printer printer;
  printer.talk("-> G28\n<- ok\n-> M220 S10\n<- ok\n-> G91\n<- ok");
  for (int i = 0; i < 60; ++i) printer.talk("-> G1 X0.5 F6000\n<- ok");
  printer.talk("-> M400\n<- ok");
  EXPECT_EQ(printer.chip.position[x], 2400);
  EXPECT_EQ(printer.chip.underruns, 0u);
}

TEST(pace, homing_runs_at_its_own_speed) {
  const auto seconds_after = [](const char* dialogue) {
    Printer printer;
    printer.talk(dialogue);
    const auto begin = printer.chip.time;
    printer.talk("-> G28 X\n<- ok");
    return static_cast<double>(printer.chip.time - begin) / clock_hz;
  };
  EXPECT_NEAR(seconds_after("-> M220 S10\n<- ok"), seconds_after("-> M220 S100\n<- ok"), 0.1);
}

TEST(pace, a_pause_holds_the_move_where_it_is_until_resume) {
  Printer printer;
  set_out(printer);
  printer.talk("-> //action:pause\n<- ok");
  printer.run(0.1);
  const auto held_at = printer.chip.position[x];
  EXPECT_LT(printer.mm(x), 20);
  printer.run(5);
  EXPECT_EQ(printer.chip.position[x], held_at);
  printer.talk("-> //action:resume\n<- ok\n-> M400\n<- ok");
  EXPECT_EQ(printer.chip.position[x], 8000);
}

TEST(pace, a_resume_goes_on_at_the_speed_of_m220) {
  Printer printer;
  set_out(printer);
  printer.talk("-> M220 S50\n<- ok\n-> //action:pause\n<- ok");
  printer.run(1);
  const double before = printer.mm(x);
  printer.talk("-> //action:resume\n<- ok");
  printer.run(4);
  EXPECT_NEAR(printer.mm(x) - before, 20, 0.5);
}

TEST(pace, a_cancel_ends_the_hold_and_the_move) {
  Printer printer;
  set_out(printer);
  printer.talk("-> //action:pause\n<- ok\n-> //action:cancel\n<- ok\n-> G91\n<- ok");
  const auto stopped_at = printer.chip.position[x];
  printer.talk("-> G1 X1\n<- ok\n-> M400\n<- ok");
  EXPECT_EQ(printer.chip.position[x], stopped_at + 80);
}

TEST(pace, every_pass_feeds_the_watchdog_of_motion) {
  Printer printer;
  set_out(printer);
  EXPECT_EQ(printer.chip.read(registers::step_generator::Watchdog::address), clock_hz / 5);
  const auto before = printer.chip.motion_watchdog_feeds;
  printer.run(1);
  EXPECT_GE(printer.chip.motion_watchdog_feeds - before, 100u);
}

TEST(pace, a_stop_by_the_watchdog_halts_the_printer) {
  Printer printer;
  set_out(printer);
  printer.chip.stop_by_watchdog();
  printer.talk("<- Error:Motion stopped by its watchdog\n<- Error:Printer halted. kill() called!");
  EXPECT_EQ(printer.chip.motors, 0u);
}

}  // namespace
}  // namespace application_test
