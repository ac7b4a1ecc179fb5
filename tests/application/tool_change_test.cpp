// SPDX-License-Identifier: Apache-2.0
// T0 and T1: where the carriage goes, and which motor turns.
#include <fmt/format.h>

#include <cmath>

#include "tests/application/described_machine.hpp"
#include "tests/application/two_tools.hpp"

namespace application_test {
namespace {

TEST_F(TwoTools, are_led_to_the_same_place_of_the_part) {
  execute({"G1 X100 Y50 Z10 F6000", "T1"});
  expect_steps(80, 49, 10.25, 0, 0);
  printer.talk("-> M114\n<* X:100.00 Y:50.00 Z:10.00 E:0.00\n<- ok");
  execute({"G1 X110 Y60", "T0"});
  expect_steps(110, 60, 10, 0, 0);
  printer.talk("-> M114\n<* X:110.00 Y:60.00 Z:10.00\n<- ok");
}

TEST_F(TwoTools, extrude_one_at_a_time_each_with_its_motor) {
  execute({"G1 X100 Y50 Z10 F6000", "G1 E5 F300"});
  expect_steps(100, 50, 10, 5, 0);
  execute({"T1", "G1 E7"});  // E goes on from where it was
  expect_steps(80, 49, 10.25, 5, 2);
  execute({"T0", "G1 E6"});
  expect_steps(100, 50, 10, 4, 2);
}

// Each motor makes the steps of its own filament, however often it rests in the middle of a step.
TEST_F(TwoTools, make_exact_totals) {
  execute({"G1 X100 Y50 Z10 F6000", "M83"});
  double asked[2]{};
  for (int i = 0; i < 58; ++i) {
    const std::size_t tool = static_cast<std::size_t>(i % 2);
    asked[tool] += 0.0307;
    execute({tool == 0 ? "T0" : "T1", "G1 E0.0307"});
  }
  EXPECT_EQ(printer.chip.position[3], std::lround(asked[0] * 500));
  EXPECT_EQ(printer.chip.position[4], std::lround(asked[1] * 500));
}

// Linear advance leads E ahead and back again: nothing of one filament comes to the other.
TEST(two_tools, make_exact_totals_with_shaped_motion) {
  application::MachineDescription machine = machine_with_two_tools();
  machine.shaping.emplace(motion::ShapingSettings{
      .shapers = {motion::Shaper{
                      .type = motion::ShaperType::zv, .millihertz = 40'000, .damping = 1000},
                  motion::Shaper{}},
      .advance_microseconds = 50'000});
  Printer printer(machine);
  printer.chip.heaters[0].celsius = printer.chip.heaters[2].celsius = 200;
  printer.talk("-> G28\n<- ok\n-> G1 X100 Y50 Z10 F6000\n<- ok\n-> M83\n<- ok");
  double asked[2]{};
  for (int i = 0; i < 12; ++i) {
    const std::size_t tool = static_cast<std::size_t>(i / 2 % 2);
    asked[tool] += 1.0307;
    printer.talk("-> T" + std::to_string(tool) + "\n<- ok\n-> G1 X" +
                 std::to_string(i % 2 == 0 ? 120 : 100) + " E1.0307 F3000\n<- ok");
  }
  printer.talk("-> M400\n<- ok");
  EXPECT_EQ(printer.chip.position[3], std::lround(asked[0] * 500));
  EXPECT_EQ(printer.chip.position[4], std::lround(asked[1] * 500));
}

TEST_F(TwoTools, hold_no_current_in_the_motor_that_rests) {
  execute({"G1 X100 Y50 Z10 E1 F6000"});
  EXPECT_EQ(printer.chip.motors, 0b01111u);
  execute({"T1", "G1 E2"});
  EXPECT_EQ(printer.chip.motors, 0b10111u);
  execute({"M84"});
  EXPECT_EQ(printer.chip.motors, 0u);
}

TEST_F(TwoTools, stay_where_they_are_with_s1) {
  execute({"G1 X100 Y50 Z10 F6000", "T1 S1"});
  expect_steps(100, 50, 10, 0, 0);
  printer.talk("-> M114\n<* X:120.00 Y:51.00 Z:9.75\n<- ok");
}

TEST(two_tools, stay_where_they_are_before_homing) {
  Printer printer(machine_with_two_tools());
  printer.talk("-> T1\n<- ok\n-> M114\n<* X:20.00 Y:1.00 Z:-0.25\n<- ok");
  printer.run(0.5);
  EXPECT_EQ(printer.chip.motors, 0u);
}

TEST_F(TwoTools, have_the_travel_of_their_own_nozzle) {
  execute({"G1 X100 Y50 Z10 F6000", "T1"});
  printer.talk(R"(
    -> G1 X19
    <- echo:Move beyond the end of X (20.00 to 220.00), not executed: "G1 X19"
    <- ok
    -> M211
    <- echo:Soft endstops: ON  Min: X20.00 Y1.00 Z-0.25  Max: X220.00 Y201.00 Z109.75
    <- ok
  )");
  execute({"G1 X219"});
  EXPECT_EQ(printer.chip.position[0], 199 * 80);
}

TEST_F(TwoTools, stay_where_the_new_nozzle_does_not_reach) {
  execute({"G1 X5 Y50 Z10 F6000"});
  printer.talk("-> T1\n<- echo:Out of reach of the new nozzle: the head stays\n<- ok");
  printer.talk("-> M114\n<* X:25.00 Y:51.00 Z:9.75\n<- ok");
  expect_steps(5, 50, 10, 0, 0);
}

TEST_F(TwoTools, are_homed_with_the_same_end_stops) {
  execute({"G1 X100 Y50 Z10 F6000", "T1", "G28"});
  printer.talk("-> M114\n<* X:20.00 Y:1.00 Z:-0.25\n<- ok");
  execute({"G1 Z10", "G1 X100 Y50"});
  expect_steps(80, 49, 10.25, 0, 0);
}

TEST_F(TwoTools, change_only_to_what_is_there) {
  printer.talk("-> T2\n<- echo:T2 Invalid extruder\n<- ok");
  execute({"G1 X100 Y50 Z10 F6000", "T0"});
  expect_steps(100, 50, 10, 0, 0);
}

// 4 mm are drawn back from the one that rests, and come forward when it is used again.
TEST_F(TwoTools, draw_filament_back_and_lift_as_m217_says) {
  printer.talk(R"(
    -> M217 S4 B0.5 E0 P300 R2400 U1200 Z2
    <- echo: M217 S4.00 B0.50 E0.00 P300.00 R2400.00 U1200.00 Z2.00
    <- ok
  )");
  execute({"G1 X100 Y50 Z10 F6000", "G1 E10 F300", "T1"});
  expect_steps(80, 49, 10.25, 6, 0);
  execute({"G1 E11", "T0"});
  expect_steps(100, 50, 10, 10.5, -3);
  execute({"T1"});
  expect_steps(80, 49, 10.25, 6.5, 1.5);
  printer.talk("-> M114\n<* E:11.00\n<- ok");
}

TEST_F(TwoTools, lift_above_the_part_while_they_travel) {
  printer.talk("-> M217 Z2\n<* Z2.00\n<- ok");
  execute({"G1 X100 Y50 Z10 F6000"});
  printer.send("T1 F600");  // 2 s for 20 mm
  std::int32_t lowest = printer.chip.position[2];
  for (int i = 0; i < 60; ++i) {
    printer.run(0.1);
    const std::int32_t x = printer.chip.position[0];
    if (x != 100 * 80 && x != 80 * 80) {
      EXPECT_EQ(printer.chip.position[2], 12.25 * 2560);
      lowest = 0;
    }
  }
  EXPECT_EQ(lowest, 0) << "was not seen on its way";
  expect_steps(80, 49, 10.25, 0, 0);
}

TEST_F(TwoTools, extrude_nothing_cold_when_they_change) {
  printer.talk("-> M217 S4\n<* S4.00\n<- ok");
  execute({"G1 X100 Y50 Z10 F6000", "M104 S0 T0"});
  printer.chip.heaters[0].celsius = 60;
  printer.run(3);
  execute({"T1"});
  expect_steps(80, 49, 10.25, 0, 0);
}

TEST_F(TwoTools, leave_a_change_that_is_stopped) {
  execute({"G1 X100 Y50 Z10 F6000"});
  printer.send("T1 F60");
  printer.run(5);
  printer.send("M410");
  printer.run(1);
  const auto x = printer.chip.position[0];
  EXPECT_LT(x, 100 * 80);
  EXPECT_GT(x, 80 * 80);
  printer.chip.from_firmware.clear();
  // The new nozzle is in use, and its coordinate is where it is.
  const double at = x / 80.0 + 20;
  execute({"G1 X130 F6000"});
  EXPECT_EQ(printer.chip.position[0], 110 * 80);
  EXPECT_GT(at, 100);
}

class ToolsWithSwap : public TwoTools {
 protected:
  ToolsWithSwap() {
    printer.talk("-> M217 S4 R60 U60\n<* S4.00\n<- ok");
    execute({"G1 X100 Y50 Z10 F6000", "G1 E10 F300"});
  }
  static std::string drawn_back(double length) {
    return fmt::format("echo:Filament is retracted by {:.2f} mm, once hot T0 pushes it forward",
                       length);
  }
};

TEST_F(ToolsWithSwap, bring_filament_forward_where_they_do_not_move) {
  execute({"T1"});
  expect_steps(80, 49, 10.25, 6, 0);
  execute({"T0 S1"});
  expect_steps(80, 49, 10.25, 10, 0);
  execute({"T1", "T0", "G91", "G1 X-75 F6000", "G90"});
  expect_steps(5, 49, 10.25, 10, -4);
  printer.talk("-> T1\n<- echo:Out of reach of the new nozzle: the head stays\n<- ok");
  expect_steps(5, 49, 10.25, 10, 0);
}

TEST_F(ToolsWithSwap, say_what_is_drawn_back_of_a_cold_one_and_bring_it_forward_when_it_is_hot) {
  execute({"T1", "M302 S250"});
  printer.talk(
      "-> T0\n<- echo:Filament is retracted by 4.00 mm, once hot T0 pushes it forward\n<- ok");
  expect_steps(100, 50, 10, 6, 0);
  execute({"M302 S170", "T0"});
  expect_steps(100, 50, 10, 10, 0);
  execute({"T0"});
  expect_steps(100, 50, 10, 10, 0);
  printer.talk("-> M114\n<* E:10.00\n<- ok");
}

// At 1 mm/s the filament is on its way back for 4 s.
TEST_F(ToolsWithSwap, refuse_a_change_that_is_stopped_before_the_new_one_is_in_use) {
  printer.send("T1");
  printer.run(2);
  printer.send("M410");
  EXPECT_EQ(printer.reply(), "echo:The change was stopped, the tool stays, not executed: \"T1\"");
  const std::string said = printer.reply().value_or("");
  const double drawn = 10 - printer.chip.position[3] / 500.0;
  EXPECT_GT(drawn, 1);
  EXPECT_LT(drawn, 3);
  EXPECT_EQ(said, drawn_back(drawn));
  printer.talk("<- ok\n<- ok\n-> M114\n<* E:10.00\n<- ok");
  execute({"T0"});
  expect_steps(100, 50, 10, 10, 0);
}

TEST_F(ToolsWithSwap, count_what_a_stop_has_left_of_the_way_forward) {
  execute({"T1"});
  printer.send("T0");
  printer.run(6.5);  // 4 s back, 4 s forward
  printer.send("M410");
  const std::string said = printer.reply().value_or("");
  const double drawn = 10 - printer.chip.position[3] / 500.0;
  EXPECT_GT(drawn, 0.5);
  EXPECT_LT(drawn, 3.5);
  EXPECT_EQ(said, drawn_back(drawn));
  printer.talk("<- ok\n<- ok");
  execute({"T0"});
  EXPECT_EQ(printer.chip.position[3], 10 * 500);
}

// G10 lifts Z, whichever nozzle it is; what lowers it is the next G11.
TEST_F(TwoTools, are_lowered_by_the_other_ones_g11) {
  execute({"M207 S3 Z2", "G1 X100 Y50 Z10 F6000", "G10"});
  expect_steps(100, 50, 12, -3, 0);
  execute({"T1"});
  expect_steps(80, 49, 12.25, -3, 0);
  execute({"G11"});
  expect_steps(80, 49, 10.25, -3, 0);
  execute({"G10", "T0"});
  expect_steps(100, 50, 12, -3, -3);
  execute({"G11"});
  expect_steps(100, 50, 10, 0, -3);
  execute({"T1", "G11"});
  expect_steps(80, 49, 10.25, 0, 0);
}

TEST_F(TwoTools, are_lifted_once_by_g10_of_both) {
  execute({"M207 S3 Z2", "G1 X100 Y50 Z10 F6000", "G10", "T1", "G10"});
  expect_steps(80, 49, 12.25, -3, -3);
  execute({"G11"});
  expect_steps(80, 49, 10.25, -3, 0);
  execute({"T0", "G11"});
  expect_steps(100, 50, 10, 0, 0);
}

// Between both places of the carriage the nozzle would come too near to the shoulder at X100 Y-120.
TEST(two_tools, stay_where_the_way_of_a_scara_is_out_of_reach) {
  application::MachineDescription machine = described_machine("scara");
  machine.second_tool = machine_with_two_tools().second_tool;
  machine.second_tool->offset = {units::Nanometers(-120'000'000)};
  Printer printer(machine);
  hang_below_end_stops(printer.chip);
  printer.talk("-> G28\n<- ok\n-> G1 X30 Y40 F6000\n<- ok\n-> G1 Y1 Z10\n<- ok\n-> M400\n<- ok");
  const auto before = printer.chip.mechanical;
  printer.talk("-> T1\n<- echo:Out of reach of the new nozzle: the head stays\n<- ok");
  EXPECT_EQ(printer.chip.mechanical, before);
  printer.talk("-> M114\n<* X:-90.00 Y:1.00 Z:10.00\n<- ok");
}

}  // namespace
}  // namespace application_test
