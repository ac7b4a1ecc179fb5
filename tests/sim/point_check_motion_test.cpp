// SPDX-License-Identifier: Apache-2.0
// The judge of the steps: motion that no line requests is found.
#include <numbers>

#include "tests/sim/point_check_fixture.hpp"

namespace {

using testing::ElementsAre;
using tests::PointCheckTest;

double cosine(double degrees) { return std::cos(degrees * std::numbers::pi / 180); }
double sine(double degrees) { return std::sin(degrees * std::numbers::pi / 180); }

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
  EXPECT_THAT(check.judgement().homed_elsewhere, ElementsAre(false, false, false, false, false));
  begin("G28 X");
  end();
  EXPECT_THAT(check.judgement().homed_elsewhere, ElementsAre(true, false, false, false, false));
}

TEST_F(PointCheckTest, finds_motion_after_the_last_line) {
  send("G28 X Y");
  send("G1 X3 F1200");
  go_to(3, 0);
  send("M400");
  clock += 1000;
  EXPECT_THAT(check.judgement().moved_after_end, ElementsAre(false, false, false, false, false));
  go_to(240, 0, 5, 0);
  clock += 1000;
  EXPECT_THAT(check.judgement().moved_after_end, ElementsAre(false, false, true, false, false));
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
  EXPECT_THAT(unasked(), ElementsAre(0, 40, 0, 0, 0));
}

TEST_F(PointCheckTest, follows_arcs_and_full_circles) {
  send("G28 X Y");
  send("G1 X20 Y10");
  go_to(20, 10);
  send("G3 X0 Y10 I-10");
  for (int degree = 1; degree <= 180; ++degree) {
    go_to(10 + 10 * cosine(degree), 10 + 10 * sine(degree));
  }
  send("G2 I10");
  send("G1 X5 Y20");
  for (int degree = 1; degree <= 360; ++degree) {
    go_to(10 - 10 * cosine(degree), 10 + 10 * sine(degree));
  }
  go_to(5, 20);
  send("M400");
  EXPECT_EQ(missed(), 0U);
  EXPECT_EQ(reached(), 4U);
  EXPECT_THAT(unasked(), ElementsAre(0, 0, 0, 0, 0));
  EXPECT_LT(check.max_deviation_steps(), 1.0);
  EXPECT_NEAR(check.length_mm(), std::hypot(20, 10) + 30 * std::numbers::pi + std::hypot(5, 10),
              1e-6);
}

// The other way round, by its chord, and once more than asked.
TEST_F(PointCheckTest, finds_arcs_that_are_none) {
  send("G28 X Y");
  send("G1 X20 Y10");
  go_to(20, 10);
  send("G3 X0 Y10 I-10");
  go_to(0, 10);
  send("M400");
  EXPECT_NEAR(check.max_deviation_mm(), 10, 0.1);
  send("G2 I10");
  for (int degree = 1; degree <= 720; ++degree) {
    go_to(10 - 10 * cosine(degree), 10 + 10 * sine(degree));
  }
  send("G1 X5");
  go_to(5, 10);
  send("M400");
  EXPECT_NEAR(static_cast<double>(unasked()[0]), 40 * 80, 10);
  EXPECT_NEAR(static_cast<double>(unasked()[1]), 40 * 80, 10);
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
  EXPECT_THAT(unasked(), ElementsAre(0, 0, 0, 14, 0));
}

}  // namespace
