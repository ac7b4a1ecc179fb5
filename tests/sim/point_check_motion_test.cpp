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

TEST_F(PointCheckTest, takes_a_babystep_at_rest_as_a_move) {
  send("G28 X Y");
  send("G1 X10 F1200");
  go_to(10, 0);
  send("M290 Z0.1");
  go_to(800, 0, 256, 0);
  send("M400");
  send("G1 X20 Z0.2");
  go_to(1600, 0, 768, 0);
  send("M290 Z-0.1");
  send("M400");
  EXPECT_EQ(missed(), 1u);  // not made
}

TEST_F(PointCheckTest, takes_a_babystep_within_the_next_line_where_one_is_under_way) {
  send("G28 X Y");
  send("G1 X10 F1200");
  go_to(5, 0);
  send("M290 Z0.1");
  go_to(10, 0);
  send("G1 X20");
  go_to(1600, 0, 256, 0);
  send("M400");
  EXPECT_EQ(missed(), 0u);
  EXPECT_EQ(check.lines_apart(), 0u);
}

TEST_F(PointCheckTest, goes_on_from_where_a_stop_has_left_it) {
  send("G28 X Y");
  send("G1 X50 Y50 F1200");
  go_to(20, 20);
  send("M410");
  send("G1 X10 Y10");
  go_to(10, 10);
  send("G91");
  send("G1 X5");
  go_to(15, 10);
  send("M400");
  EXPECT_EQ(missed(), 0u);
  EXPECT_EQ(check.max_deviation_steps() < 2, true);
}

report::MachineFacts with_play() {
  report::MachineFacts facts;
  facts.play = report::PlayFacts{.lengths = {report::femtometers_per_mm / 5}};
  return facts;
}

class BacklashTest : public PointCheckTest {
 protected:
  BacklashTest() : PointCheckTest(with_play()) { send("G28 X Y"); }
};

// 0.2 mm are 16 steps of X; M425 halves them.
TEST_F(BacklashTest, is_good_where_motors_cross_the_play) {
  send("G1 X10 F1200");
  go_to(816, 0, 0, 0);
  send("G1 X5 Y5");
  go_to(800, 0, 0, 0);
  go_to(400, 400, 0, 0);
  send("M400");
  send("M425 F0.5");
  send("G1 X6");
  go_to(488, 400, 0, 0);
  send("G1 X5.5");
  go_to(440, 400, 0, 0);
  send("M400");
  EXPECT_EQ(missed(), 0u);
  EXPECT_THAT(unasked(), ElementsAre(0, 0, 0, 0, 0));
  EXPECT_LT(check.max_deviation_steps(), 1.0);
}

TEST_F(BacklashTest, is_bad_where_they_do_not) {
  send("G1 X10 F1200");
  go_to(10, 0);
  send("G1 X5 Y5");
  go_to(5, 5);
  send("M400");
  EXPECT_EQ(missed(), 1u);
}

}  // namespace
