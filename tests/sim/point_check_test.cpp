// SPDX-License-Identifier: Apache-2.0
// The judge of the steps: right ones pass on all axes, and a point that is not reached is missed.
#include "tests/sim/point_check_fixture.hpp"

namespace {

using report::Steps;
using testing::ElementsAre;
using tests::PointCheckTest;

TEST_F(PointCheckTest, passes_a_path_that_keeps_to_the_lines) {
  send("G28 X Y");
  send("G1 X10.001 Y5.503 F1200");
  send("G1 X20.3 Y5.503");
  send("G1 X20.3 Y7");
  go_to(10.001, 5.503);
  go_to(20.3, 5.503);
  go_to(20.3, 7);
  send("M400");
  EXPECT_EQ(missed(), 0U);
  EXPECT_EQ(reached(), 3U);
  EXPECT_THAT(unasked(), ElementsAre(0, 0, 0, 0, 0));
  EXPECT_LT(check.max_deviation_mm(), 1.0 / 80);
  EXPECT_NEAR(check.length_mm(), std::hypot(10.001, 5.503) + (20.3 - 10.001) + (7 - 5.503), 1e-9);
}

TEST_F(PointCheckTest, misses_a_point_that_the_edges_cut_off) {
  send("G28 X Y");
  send("G1 X10 Y0");
  send("G1 X10 Y10");
  go_to(9.95, 0);
  go_to(9.95, 10);
  go_to(10, 10);
  send("M400");
  EXPECT_EQ(missed(), 1U);
  EXPECT_EQ(reached(), 1U);
  EXPECT_NEAR(check.max_deviation_mm(), 0.05, 1e-9);
  const report::MissedPoint point = check.judgement().list.at(0);
  EXPECT_EQ(point.file_line, 2U);
  EXPECT_EQ(point.text, "G1 X10 Y0");
  EXPECT_TRUE(point.axes[0].missed);
  EXPECT_FALSE(point.axes[1].missed);
  EXPECT_EQ(point.axes[0].wanted_steps, 800);
  EXPECT_EQ(point.axes[0].reached_steps, 796);
  EXPECT_EQ(point.axes[0].wanted_mm, 10);
  EXPECT_EQ(point.axes[0].reached_mm, 9.95);
}

TEST_F(PointCheckTest, misses_the_end_where_steps_are_lost) {
  send("G28 X Y");
  send("G1 X10 Y0");
  go_to(8, 0);
  send("M400");
  EXPECT_EQ(missed(), 1U);
  EXPECT_NEAR(check.max_deviation_mm(), 2.0, 1e-9);
}

TEST_F(PointCheckTest, misses_a_point_by_a_single_step_of_each_axis) {
  for (std::size_t axis = 0; axis < 4; ++axis) {
    const std::uint64_t before = check.judgement().missed_by_axis[axis];
    send("G91");
    send("G1 X1 Y1 Z1 E1");
    Steps to{position[0] + 80, position[1] + 80, position[2] + 2560, position[3] + 500};
    to[axis] -= 1;
    go_to(to[0], to[1], to[2], to[3]);
    send("M400");
    EXPECT_EQ(missed(), axis + 1) << axis;
    EXPECT_EQ(check.judgement().missed_by_axis[axis], before + 1) << axis;
    step(axis, 1);  // the next line begins where it should
  }
}

TEST_F(PointCheckTest, misses_all_points_behind_a_lost_step_and_finds_none_of_them_wrong_twice) {
  send("G28 X Y");
  for (int i = 1; i <= 20; ++i) {
    send("G1 X" + std::to_string(i) + " Y" + std::to_string(i % 2) + " E" + std::to_string(i));
  }
  for (int i = 1; i <= 20; ++i) go_to(80 * i - (i > 5 ? 1 : 0), 80 * (i % 2), 0, 500 * i);
  send("M400");
  EXPECT_EQ(reached(), 5U);
  EXPECT_EQ(missed(), 15U);
  EXPECT_THAT(check.judgement().missed_by_axis, ElementsAre(15, 0, 0, 0, 0));
}

TEST_F(PointCheckTest, rounds_to_the_nearest_step_and_halves_away_from_zero) {
  send("G28 X Y");
  // A step is 0.0125 mm: 0.00625 is the half.
  for (const auto& [word, step] : std::vector<std::pair<std::string, std::int64_t>>{
           {"0.00625", 1},
           {"0.006249", 0},
           {"-0.00625", -1},
           {"0.01875", 2},
           {"0.018749", 1},
           {"0.0062499999", 1}}) {  // the seventh decimal rounds up
    send("G1 X" + word);
    go_to(step, 0, 0, 0);
    send("M400");
    EXPECT_EQ(missed(), 0U) << word;
  }
  EXPECT_EQ(reached(), 6U);
}

TEST_F(PointCheckTest, keeps_the_sum_of_moves_shorter_than_a_step) {
  send("G28 X Y");
  send("G91");
  for (int i = 1; i <= 200; ++i) {
    send("G1 X0.005");
    go_to((i * 4 + 5) / 10, 0, 0, 0);  // 0.4 steps each, rounded
  }
  send("M400");
  EXPECT_EQ(position[0], 80);
  EXPECT_EQ(reached(), 200U);
  EXPECT_EQ(missed(), 0U);
}

TEST_F(PointCheckTest, misses_where_moves_shorter_than_a_step_are_lost) {
  send("G28 X Y");
  send("G1 X20");
  go_to(20, 0);
  for (int i = 1; i <= 200; ++i) send("G1 X" + std::to_string(20 + 0.005 * i));
  send("G1 X20");
  go_to(19, 0);
  send("M400");
  EXPECT_EQ(reached(), 2U);  // X20 and X20.005, which rounds to the same step
  EXPECT_EQ(missed(), 200U);
}

TEST_F(PointCheckTest, misses_a_last_point_that_the_machine_has_left_again) {
  send("G28 X Y");
  send("G1 X10");
  go_to(10, 0);
  go_to(10.1, 0);
  send("M400");
  EXPECT_EQ(reached(), 0U);
  EXPECT_EQ(missed(), 1U);
}

TEST_F(PointCheckTest, stays_right_over_more_points_than_it_keeps_in_mind) {
  send("G28 X Y");
  for (int i = 0; i < 5000; ++i) {
    send(i % 2 == 0 ? "G1 X1 Y1" : "G1 X0 Y1");
    // Every tenth line is left out, and the one after it with it.
    if (i % 20 < 18) go_to(i % 2 == 0 ? 1 : 0, 1);
  }
  send("M400");
  EXPECT_EQ(reached() + missed(), 5000U);
  EXPECT_EQ(missed(), 250U);  // the second of each pair ends where the machine stands
}

}  // namespace
