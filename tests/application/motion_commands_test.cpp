// SPDX-License-Identifier: Apache-2.0
// Moves, coordinates and stops, as dialogues and by the positions of the axes.
#include <gtest/gtest.h>

#include "tests/application/dialogue.hpp"

namespace application_test {
namespace {

constexpr std::size_t x = 0, y = 1, z = 2, e = 3;

// A homed printer with a hot nozzle.
void prepare(Printer& printer) {
  printer.chip.heaters[0].celsius = 200;
  printer.talk(R"(
    -> G28
    <- ok
    -> M104 S200
    <- ok
  )");
}

TEST(motion_commands, refuses_a_parameter_that_it_does_not_know) {
  Printer printer;
  printer.talk(R"(
    -> G28 Q
    <- echo:Unknown parameter, not executed: "G28 Q"
    <- ok
    -> G1 X5 U3
    <- echo:Unknown parameter, not executed: "G1 X5 U3"
    <- ok
    -> G92 X0 A1
    <- echo:Unknown parameter, not executed: "G92 X0 A1"
    <- ok
    -> G28 W
    <- ok
  )");
  EXPECT_EQ(printer.counters.commands_refused, 3u);
}

// A refused line has no effect, its feedrate included.
TEST(motion_commands, keeps_the_feedrate_where_the_line_is_refused) {
  Printer printer;
  prepare(printer);
  printer.talk("-> G1 X10 F600\n<- ok\n-> M400\n<- ok\n-> G1 X900 F6000\n<* not executed\n<- ok");
  const auto began = printer.chip.time;
  printer.talk("-> G1 X20\n<- ok\n-> M400\n<- ok");
  EXPECT_NEAR(static_cast<double>(printer.chip.time - began) / clock_hz, 1.0, 0.1);
}

TEST(motion_commands, refuses_a_coordinate_without_a_number) {
  Printer printer;
  prepare(printer);
  const auto before = printer.chip.mechanical;
  printer.talk(R"(
    -> G1 Xabc Y10
    <- echo:Unknown parameter, not executed: "G1 Xabc Y10"
    <- ok
    -> G0 Z
    <- echo:Number missing after Z, not executed: "G0 Z"
    <- ok
    -> G92 E
    <- echo:Number missing after E, not executed: "G92 E"
    <- ok
    -> M400
    <- ok
  )");
  EXPECT_EQ(printer.chip.mechanical, before);
}

TEST(motion_commands, moves_to_where_the_line_says_to_the_step) {
  Printer printer;
  prepare(printer);
  printer.talk(R"(
    -> G1 X100.0125 Y50 Z0.3 E1.002 F6000
    <- ok
    -> M400
    <- ok
  )");
  EXPECT_EQ(printer.chip.position[x], 8001);
  EXPECT_EQ(printer.chip.position[y], 4000);
  EXPECT_EQ(printer.chip.position[z], 768);
  EXPECT_EQ(printer.chip.position[e], 501);
}

TEST(motion_commands, relative_moves_never_drift) {
  Printer printer;
  prepare(printer);
  printer.talk("-> G91\n<- ok");
  for (int i = 0; i < 300; ++i) {
    printer.talk("-> G1 X0.0333\n<- ok");  // 2.664 steps each
  }
  printer.talk("-> M400\n<- ok");
  EXPECT_EQ(printer.chip.position[x], 799);  // 9.99 mm
}

TEST(motion_commands, g92_changes_what_the_host_believes_and_no_step) {
  Printer printer;
  prepare(printer);
  printer.talk(R"(
    -> G1 X10 E2 F3000
    <- ok
    -> G92 X0 E0
    <- ok
    -> G1 X5 E1
    <- ok
    -> M400
    <- ok
    -> M114
    <* X:5.00 Y:0.00 Z:0.00 E:1.00 Count X:1200
    <- ok
  )");
  EXPECT_EQ(printer.chip.position[e], 1500);
}

TEST(motion_commands, inches_are_25_4_millimetres) {
  Printer printer;
  prepare(printer);
  printer.talk(
      "-> G20\n<- ok\n-> G1 X1 F100\n<- ok\n-> G21\n<- ok\n-> G1 Y1\n<- ok\n-> M400\n<- ok");
  EXPECT_DOUBLE_EQ(printer.mm(x), 25.4);
  EXPECT_DOUBLE_EQ(printer.mm(y), 1.0);
}

TEST(motion_commands, refuses_a_target_beyond_the_travel_and_moves_nothing) {
  Printer printer;
  prepare(printer);
  printer.talk(R"(
    -> G1 X900 Y10 E1
    <- echo:Move beyond the end of X (0.00 to 200.00), not executed: "G1 X900 Y10 E1"
    <- ok
    -> G1 Z-1
    <* echo:Move beyond the end of Z (0.00 to 110.00)
    <- ok
    -> M400
    <- ok
    -> M114
    <- X:0.00 Y:0.00 Z:0.00 E:0.00 Count X:0 Y:0 Z:0
    <- ok
  )");
}

TEST(motion_commands, moves_before_homing_know_no_bounds) {
  Printer printer;
  printer.talk("-> G91\n<- ok\n-> G1 X-5 F3000\n<- ok\n-> M400\n<- ok");
  EXPECT_EQ(printer.chip.position[x], -400);
}

TEST(motion_commands, a_cold_nozzle_moves_without_extruding) {
  Printer printer;
  printer.talk(R"(
    -> G28
    <- ok
    -> G1 X10 E5 F3000
    <- echo: cold extrusion prevented
    <- ok
    -> M400
    <- ok
    -> M114
    <* X:10.00 Y:0.00 Z:0.00 E:5.00 Count X:800
    <- ok
  )");
  EXPECT_EQ(printer.chip.position[e], 0);
}

TEST(motion_commands, more_than_20_cm_of_filament_in_a_line_is_left_out_either_way) {
  for (const char* line : {"G1 X1 E250 F3000", "G1 X1 E-250 F3000", "G1 X1 E-200.000001 F3000"}) {
    Printer printer;
    prepare(printer);
    printer.talk(std::string("-> ") + line +
                 "\n<- echo: too long extrusion prevented\n<- ok\n-> M400\n<- ok");
    EXPECT_EQ(printer.chip.position[e], 0) << line;
    EXPECT_EQ(printer.chip.position[x], 80) << line;
  }
}

TEST(motion_commands, twenty_cm_of_filament_are_not_too_long) {
  Printer printer;
  prepare(printer);
  printer.talk("-> G1 E-200 F4000\n<- ok\n-> M400\n<- ok");
  EXPECT_EQ(printer.chip.position[e], -100'000);
}

TEST(motion_commands, malformed_and_overlong_numbers_move_nothing) {
  Printer printer;
  prepare(printer);
  printer.talk(R"(
    -> G1 X1.2.3
    <* echo:
    <- ok
    -> G1 X99999999999999999999
    <* echo:
    <- ok
    -> G1 E4000000000
    <* echo:
    <- ok
    -> M400
    <- ok
    -> M114
    <- X:0.00 Y:0.00 Z:0.00 E:0.00 Count X:0 Y:0 Z:0
    <- ok
  )");
  EXPECT_GE(printer.counters.commands_refused, 3u);
}

TEST(motion_commands, flow_and_speed_factors_scale_extrusion_and_nothing_else) {
  Printer printer;
  prepare(printer);
  printer.talk("-> M221 S50\n<- ok\n-> M220 S200\n<- ok\n-> G1 X10 E4 F600\n<- ok\n-> M400\n<- ok");
  EXPECT_EQ(printer.chip.position[e], 1000);
  EXPECT_EQ(printer.chip.position[x], 800);
  printer.talk("-> M114\n<* E:4.00\n<- ok\n-> M220\n<- FR:200%\n<- ok");
}

TEST(motion_commands, m410_stops_at_once_and_keeps_a_true_position) {
  Printer printer;
  prepare(printer);
  printer.talk("-> G1 X190 F3000\n<- ok");
  printer.run(1.0);
  printer.talk("-> M410\n<- ok\n-> M400\n<- ok");
  EXPECT_GT(printer.chip.position[x], 80);
  EXPECT_LT(printer.chip.position[x], 15'000);
  const auto stopped_at = printer.chip.position[x];
  printer.talk("-> G91\n<- ok\n-> G1 X1\n<- ok\n-> M400\n<- ok");
  EXPECT_EQ(printer.chip.position[x], stopped_at + 80);
}

TEST(motion_commands, dwells_for_the_time_after_the_motion) {
  Printer printer;
  prepare(printer);
  const auto begin = printer.chip.time;
  printer.talk("-> G4 P500\n<- ok");
  const double seconds = static_cast<double>(printer.chip.time - begin) / clock_hz;
  EXPECT_GE(seconds, 0.5);
  EXPECT_LT(seconds, 0.55);
}

TEST(motion_commands, m84_switches_the_motors_off_when_the_motion_has_ended) {
  Printer printer;
  prepare(printer);
  printer.talk("-> G1 X50 F3000\n<- ok\n-> M84 E\n<- ok");
  EXPECT_EQ(printer.chip.position[x], 4000);
  EXPECT_EQ(printer.chip.motors, 0b0111u);
  printer.talk("-> M84\n<- ok");
  EXPECT_EQ(printer.chip.motors, 0u);
}

TEST(motion_commands, motors_at_rest_are_switched_off_after_the_time_of_m84_s) {
  Printer printer;
  prepare(printer);
  printer.run(5);
  printer.talk("-> M84 S2\n<- ok");
  printer.run(1.8);
  EXPECT_NE(printer.chip.motors, 0u);
  printer.run(0.4);
  EXPECT_EQ(printer.chip.motors, 0u);
}

}  // namespace
}  // namespace application_test
