// SPDX-License-Identifier: Apache-2.0
// G53 to G59.3, G92.1, M200, M206 and M428, by where the axes go.
#include "tests/application/homed_printer.hpp"

namespace application_test {
namespace {

class Workspace : public HomedPrinter {
 protected:
  Workspace() { execute({"G1 X10 Y10 Z5 F6000"}); }
};

TEST_F(Workspace, has_nine_systems_each_with_its_shift) {
  execute({"G55", "G92 X0 Y0", "G59.3", "G92 X5 Z1", "G54"});
  execute({"G1 X11 Y12"});  // G54 has no shift
  expect(11, 12, 5);
  execute({"G55", "G1 X3 Y4"});
  expect(13, 14, 5);
  execute({"G59.3", "G1 X7 Y20 Z2"});
  expect(12, 20, 6);
  execute({"G59.2", "G1 X7"});
  expect(7, 20, 6);
}

TEST_F(Workspace, keeps_a_shift_over_homing_until_it_is_selected_again) {
  execute({"G54", "G92 X100", "G28 X", "G1 X3"});
  expect(3, 10, 5);
  execute({"G54", "G1 X95"});
  expect(5, 10, 5);
}

TEST_F(Workspace, shifts_the_machines_own_coordinates_before_one_is_selected) {
  execute({"G92 X0", "G1 X1"});
  expect(11, 10, 5);
  execute({"G57", "G1 X1"});
  expect(1, 10, 5);
}

TEST_F(Workspace, leaves_its_shifts_with_g92_1) {
  execute({"G56", "G92 X0 Y0 Z0 E7", "G92.1", "G1 X1 Y2 Z3"});
  expect(1, 2, 3);
  execute({"G54", "G56", "G1 X4"});  // the system has lost its shift, too
  expect(4, 2, 3);
  execute({"G1 E8"});  // E keeps its coordinate
  EXPECT_NEAR(printer.mm(e), 1, step);
}

TEST_F(Workspace, is_passed_over_by_g53_for_one_line) {
  execute({"G55", "G92 X0 Y0", "G53 G1 X20 F3000", "G1 Y1"});
  expect(20, 11, 5);
  execute({"g53g0x2y2", "G1 X0"});
  expect(10, 2, 5);
  execute({"G53", "G1 X1"});  // alone it has no effect
  expect(11, 2, 5);
}

TEST_F(Workspace, has_g53_also_before_an_arc) {
  execute({"G92 X0 Y0", "G53 G2 X14 Y10 I2 J0", "G1 X5"});
  expect(15, 10, 5);
}

TEST_F(Workspace, is_not_what_relative_lines_ask_for) {
  execute({"G55", "G92 X0", "G91", "G53 G1 X2 Y1"});
  expect(12, 11, 5);
}

TEST_F(Workspace, begins_where_m206_says_also_after_homing) {
  execute({"M206 X2 Z-0.5", "G1 X10 Z4"});
  expect(8, 10, 4.5);
  execute({"G28 X", "G1 X10"});
  expect(8, 10, 4.5);
  printer.talk("-> M206\n<- M206 X2.000 Y0.000 Z-0.500\n<- ok\n");
  execute({"M206 X0 Y1", "G1 X10 Y10"});
  expect(10, 9, 4.5);
}

TEST_F(Workspace, begins_at_the_nearer_end_after_m428) {
  execute({"M428", "G1 X1 Y2 Z3"});
  expect(11, 12, 8);
  execute({"G1 X90"});
  printer.talk("-> M428\n<* Too far\n<- ok\n");
}

TEST(workspaces, need_homing_for_m428) {
  Printer printer;
  printer.talk("-> M428\n<* Home XYZ first\n<- ok\n");
}

TEST_F(Workspace, has_only_the_systems_that_there_are) {
  printer.talk("-> G59.4\n<- echo:Unknown command: \"G59.4\"\n<- ok\n");
  printer.talk("-> G54.1\n<- echo:Unknown command: \"G54.1\"\n<- ok\n");
  printer.talk("-> G92.2\n<- echo:Unknown command: \"G92.2\"\n<- ok\n");
}

// 1 mm of 1.75 mm filament is 2.405 mm³.
TEST_F(Workspace, counts_volumes_of_filament_with_m200) {
  execute({"M200 D1.75", "G1 E24.053 F300"});
  EXPECT_NEAR(printer.mm(e), 10, step);
  printer.talk("-> M200\n<- M200 S1 D1.750\n<- ok\n");
  execute({"M200 S0", "G92 E0", "G1 E5"});
  EXPECT_NEAR(printer.mm(e), 15, step);
  execute({"M200 S1", "G1 E-19.053"});
  EXPECT_NEAR(printer.mm(e), 5, step);
  execute({"M200 D0", "G92 E0", "G1 E1"});
  EXPECT_NEAR(printer.mm(e), 6, step);
  printer.talk("-> M200 D0.2\n<* D is neither 0 nor 0.5 to 10 mm\n<- ok\n");
}

TEST_F(Workspace, limits_the_length_of_filament_and_not_its_volume) {
  execute({"M83", "M200 D1.75", "G1 E300 F3000"});  // 125 mm
  EXPECT_NEAR(printer.mm(e), 124.726, step);
  execute({"M200 D0.5"});
  printer.talk("-> G1 E100\n<- echo: too long extrusion prevented\n<- ok\n");  // 509 mm
  printer.talk("-> M221 S999\n<- ok\n-> G1 E200\n<- echo: too long extrusion prevented\n<- ok\n");
  EXPECT_NEAR(printer.mm(e), 124.726, step);
}

TEST_F(Workspace, takes_diameters_in_whole_micrometres) {
  execute({"M200 D1.7509"});
  printer.talk("-> M200\n<- M200 S1 D1.751\n<- ok\n");
  execute({"G1 E24.0805 F300"});
  EXPECT_NEAR(printer.mm(e), 10, step);
}

TEST_F(Workspace, counts_volumes_also_after_a_stop) {
  execute({"M200 D1.75", "G92 E0"});
  printer.talk("-> G1 E100 F600\n<- ok\n");
  printer.run(2);
  printer.talk("-> M410\n<- ok\n-> G92 X0\n<- ok\n");
  const double made = printer.mm(e);
  ASSERT_GT(made, 1);
  execute({"G1 E100"});
  EXPECT_NEAR(printer.mm(e), 41.576, 0.01);
}

TEST_F(Workspace, has_g53_before_moves_only) {
  for (const char* line : {"G53 G28", "G53 G92 X5", "G53 G53 G1 X5"}) {
    printer.talk("-> " + std::string(line) + "\n<* not executed\n<- ok\n");
  }
  printer.talk("-> G53 X5\n<* Unknown parameter\n<- ok\n");
  expect(10, 10, 5);
}

}  // namespace
}  // namespace application_test
