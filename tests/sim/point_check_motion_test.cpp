// SPDX-License-Identifier: Apache-2.0
// The judge of the steps: motion that no line requests is found.
#include "tests/sim/point_check_fixture.hpp"

namespace {

using testing::ElementsAre;
using tests::PointCheckTest;

TEST_F(PointCheckTest, finds_lines_on_which_z_or_e_goes_by_itself) {
  send("G28 X Y");
  send("M83");
  send("G1 X10 E1 F1200");
  go_to(800, 0, 0, 500);
  EXPECT_EQ(check.lines_apart(), 0u);
  send("G1 X20 E1");
  go_to(1600, 0, 0, 500);
  go_to(1600, 0, 0, 1000);
  send("G1 X10 Y5 Z1");
  go_to(1600, 0, 2560, 1000);
  go_to(800, 400, 2560, 1000);
  send("M400");
  EXPECT_EQ(check.lines_apart(), 2u);
  EXPECT_EQ(missed(), 0u);
}

TEST_F(PointCheckTest, finds_homing_that_ends_away_from_the_end_stop) {
  send("G28 X Y");
  send("G1 X30 Y1 F1200");
  go_to(30, 1);
  EXPECT_THAT(check.judgement().homed_elsewhere, ElementsAre(false, false, false, false));
  begin("G28 X");
  end();
  EXPECT_THAT(check.judgement().homed_elsewhere, ElementsAre(true, false, false, false));
}

TEST_F(PointCheckTest, finds_motion_after_the_last_line) {
  send("G28 X Y");
  send("G1 X3 F1200");
  go_to(3, 0);
  send("M400");
  clock += 1000;
  EXPECT_THAT(check.judgement().moved_after_end, ElementsAre(false, false, false, false));
  go_to(240, 0, 5, 0);
  clock += 1000;
  EXPECT_THAT(check.judgement().moved_after_end, ElementsAre(false, false, true, false));
}

TEST_F(PointCheckTest, measures_how_far_a_path_leaves_the_line) {
  send("G28 X Y");
  send("G1 X10 Y0");
  go_to(5, 0);
  go_to(5, 0.25);
  go_to(10, 0.25);
  go_to(10, 0);
  send("M400");
  EXPECT_NEAR(check.max_deviation_mm(), 0.25, 1e-9);
  EXPECT_THAT(unasked(), ElementsAre(0, 40, 0, 0));
}

TEST_F(PointCheckTest, finds_steps_that_no_line_asks_for_although_all_points_are_reached) {
  send("G28 X Y");
  send("G1 X10");
  go_to(10, 0);
  go_to(800, 0, 0, 7);
  go_to(800, 0, 0, 0);
  send("G1 X20");
  go_to(20, 0);
  send("M400");
  EXPECT_EQ(missed(), 0U);
  EXPECT_THAT(unasked(), ElementsAre(0, 0, 0, 14));
}

}  // namespace
