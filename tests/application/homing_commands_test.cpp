// SPDX-License-Identifier: Apache-2.0
// G28: where each axis is afterwards, and how far it is pushed where an end stop fails.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>

#include "tests/application/dialogue.hpp"

namespace application_test {
namespace {

constexpr std::size_t x = 0, y = 1, z = 2;

TEST(homing_commands, homes_every_axis_to_its_end_stop) {
  Printer printer;
  printer.talk(R"(
    -> G28
    <- ok
    -> M114
    <- X:0.00 Y:0.00 Z:0.00 E:0.00 Count X:0 Y:0 Z:0
    <- ok
  )");
  for (const std::size_t axis : {x, y, z}) EXPECT_LE(std::abs(printer.chip.mechanical[axis]), 1);
}

TEST(homing_commands, homes_only_the_axes_that_are_named) {
  Printer printer;
  const auto z_before = printer.chip.mechanical[z];
  printer.talk(R"(
    -> G28 X Y
    <- ok
  )");
  EXPECT_EQ(printer.chip.mechanical[z], z_before);
  EXPECT_LE(std::abs(printer.chip.mechanical[y]), 1);
}

// Their places are between steps: parts of a step add up over a print, homed in between or not.
TEST(homing_commands, leaves_the_other_axes_where_they_are_to_the_part_of_a_step) {
  const auto steps_with = [](const char* between) {
    Printer printer;
    printer.talk("-> M302 S0\n<- ok\n-> G28\n<- ok\n-> G91\n<- ok\n-> M83\n<- ok");
    for (int i = 0; i < 10; ++i) {
      printer.talk("-> G1 Y0.103 Z0.0101 E0.333 F600\n<- ok");
      printer.talk(between);
    }
    printer.talk("-> M400\n<- ok");
    const auto& steps = printer.chip.mechanical;
    return std::array{steps[y], steps[z], steps[3]};
  };
  EXPECT_EQ(steps_with("-> G28 X\n<- ok"), steps_with("-> M400\n<- ok"));
}

// Between any two polls of a pass, depending on the start.
TEST(homing_commands, sees_an_end_stop_whenever_it_is_reached) {
  for (std::int64_t start = 400; start < 440; ++start) {
    Printer printer;
    printer.chip.mechanical[x] = start;
    printer.chip.clocks_per_status_read = clock_hz / 1000;
    printer.talk("-> G28 X\n<- ok");
    EXPECT_LE(std::abs(printer.chip.mechanical[x]), 1) << "from " << start;
  }
}

// A rotor that was stopped at full speed swings about its place for some milliseconds.
TEST(homing_commands, lets_the_motor_come_to_rest_before_it_turns_back) {
  Printer printer;
  printer.send("G28 X");
  constexpr double millisecond = 0.001;
  for (int i = 0; i < 60'000 && printer.chip.mechanical[x] > 0; ++i) printer.run(millisecond);
  ASSERT_LE(printer.chip.mechanical[x], 0);
  const auto stopped_at = printer.chip.mechanical[x];
  int milliseconds = 0;
  for (; milliseconds < 1'000 && printer.chip.mechanical[x] == stopped_at; ++milliseconds) {
    printer.run(millisecond);
  }
  EXPECT_GE(milliseconds, 45);
  EXPECT_LT(milliseconds, 500);
}

TEST(homing_commands, halts_when_an_end_stop_is_never_found) {
  Printer printer;
  printer.chip.end_stops_work = false;
  printer.talk(R"(
    -> G28 X
    <* Error:Homing failed on X: 
    <- Error:Printer halted. kill() called!
  )");
  EXPECT_EQ(printer.chip.motors, 0u);
}

// How far Z is pushed beyond its end stop, which does not close any more, in mm. The fault ends
// all that follows.
double push_of_z(Printer& printer) {
  printer.chip.end_stops_work = false;
  printer.talk(R"(
    -> G28 Z
    <* Error:Homing failed on Z: 
    <- Error:Printer halted. kill() called!
  )");
  const auto pushed = printer.chip.mechanical[z];
  printer.send("G28 Z");
  printer.run(5);
  EXPECT_EQ(printer.chip.mechanical[z], pushed) << "pushes again";
  std::printf("%lld steps beyond the end stop\n", static_cast<long long>(-pushed));
  return static_cast<double>(-pushed) / 2560;
}

TEST(homing_commands, pushes_an_axis_no_farther_than_its_travel_and_a_margin) {
  Printer printer;
  printer.chip.mechanical[z] = 0;
  EXPECT_LT(push_of_z(printer), 110 + 2.1);
}

TEST(homing_commands, pushes_an_axis_that_knows_where_it_is_no_farther_than_a_margin) {
  Printer printer;
  printer.talk("-> G28\n<- ok\n-> G1 Z10 F480\n<- ok\n-> M400\n<- ok");
  EXPECT_LT(push_of_z(printer), 2.1);
}

TEST(homing_commands, does_not_know_where_an_axis_is_whose_motor_was_off) {
  Printer printer;
  printer.talk("-> G28\n<- ok\n-> G1 Z10 F480\n<- ok\n-> M84\n<- ok");
  printer.chip.mechanical[z] += 80 * 2560;  // by hand
  printer.talk("-> G28 Z\n<- ok");
  EXPECT_LE(std::abs(printer.chip.mechanical[z]), 1);
}

TEST(homing_commands, an_end_stop_that_never_opens_pushes_nothing) {
  Printer printer;
  printer.chip.end_stops_stuck = 1u << z;
  printer.talk(R"(
    -> G28 Z
    <* Error:Homing failed on Z: 
    <- Error:Printer halted. kill() called!
  )");
  EXPECT_GE(printer.chip.mechanical[z], 30'000);
}

}  // namespace
}  // namespace application_test
