// SPDX-License-Identifier: Apache-2.0
// The judge of the steps: what each line of a file requests, and when it is judged.
#include "tests/sim/point_check_fixture.hpp"

namespace {

using testing::ElementsAre;
using tests::PointCheckTest;

TEST_F(PointCheckTest, judges_lines_that_step_no_axis_by_where_the_axes_stand) {
  send("G28 X Y");
  send("G1 X10");
  send("G1 X10.001");
  send("G1 X10");
  go_to(10, 0);
  send("G1 Y0.001");
  send("M400");
  EXPECT_EQ(reached(), 4U);
  go_to(10.05, 0);  // a stray motion
  send("G1 Y0");
  send("M400");
  EXPECT_EQ(missed(), 1U);
}

TEST_F(PointCheckTest, expects_nothing_of_a_refused_command) {
  send("G28 X Y");
  send("G1 X500", false);
  send("G1 X1");
  go_to(1, 0);
  send("M400");
  EXPECT_EQ(missed(), 0U);
  EXPECT_NEAR(check.length_mm(), 1.0, 1e-9);
}

TEST_F(PointCheckTest, misses_a_prevented_extrusion_and_judges_the_lines_behind_it_from_there) {
  send("G28 X Y");
  begin("G1 X1 E5");
  check.reply(clock, "echo: cold extrusion prevented");
  end();
  go_to(1, 0);
  send("G1 X2 E6");
  go_to(160, 0, 0, 500);
  send("M400");
  EXPECT_EQ(reached(), 1U);
  EXPECT_EQ(missed(), 1U);
  EXPECT_THAT(check.judgement().missed_by_axis, ElementsAre(0, 0, 0, 1, 0));
  EXPECT_EQ(check.judgement().list.at(0).axes[3].wanted_mm, 5);
}

TEST_F(PointCheckTest, understands_offsets_relative_moves_inches_and_flow) {
  send("G28");
  send("G92 X100 E3");
  send("G1 X101 E5");
  go_to(80, 0, 0, 1000);
  send("G91");
  send("G1 X1 Y2");
  go_to(2, 2);
  send("G20");
  send("G1 Y1");
  go_to(2, 27.4);
  send("G90");
  send("M83");
  send("G21");
  send("M221 S50");
  send("G1 E-3");
  go_to(position[0], position[1], 0, 250);
  send("M82");
  send("G92 E0");
  send("G1 E2");
  go_to(position[0], position[1], 0, 750);
  send("M400");
  EXPECT_EQ(reached(), 5U);
  EXPECT_EQ(missed(), 0U);
}

TEST_F(PointCheckTest, keeps_the_place_where_the_steps_per_millimetre_change) {
  send("G28");
  send("G1 X10");
  go_to(800, 0, 0, 0);
  send("M92 X100");
  send("G1 X11");
  go_to(900, 0, 0, 0);
  send("M400");
  EXPECT_EQ(reached(), 2U);
  EXPECT_EQ(missed(), 0U);
}

TEST_F(PointCheckTest, checks_moves_before_homing_from_where_the_machine_stands) {
  send("G91");
  send("G1 X1");
  for (int i = 0; i < 80; ++i) {
    ++clock;
    step(0, 1);
  }
  send("M400");
  EXPECT_EQ(reached(), 1U);
  EXPECT_LT(check.max_deviation_mm(), 1e-9);
}

TEST_F(PointCheckTest, lets_a_second_homing_do_what_it_wants_after_the_moves_before_it) {
  send("G28 X Y");
  send("G1 X10 Y10");
  begin("G28 X0 Y0");
  go_to(10, 10);
  go_to(-0.0125, 10);
  go_to(2, 10);
  go_to(0, 0);
  end();
  send("G1 X1");
  go_to(1, 0);
  send("M400");
  EXPECT_EQ(missed(), 0U);
  EXPECT_EQ(reached(), 2U);
  EXPECT_LT(check.max_deviation_mm(), 1.0 / 80);
}

TEST_F(PointCheckTest, follows_a_host_with_several_lines_in_flight_one_of_them_refused) {
  send("G28 X Y");
  begin("G1 X1");
  begin("G1 X500");
  begin("G1 X2");
  go_to(2, 0);  // before any of them is answered
  end();
  end(false);
  end();
  send("M400");
  EXPECT_EQ(reached(), 2U);
  EXPECT_EQ(missed(), 0U);
}

TEST_F(PointCheckTest, settles_at_m400_also_where_the_next_line_has_been_sent_before_its_end) {
  send("G28 X Y");
  begin("G1 X1");
  begin("M400");
  begin("G1 X2");
  end();
  go_to(1, 0);
  end();
  EXPECT_EQ(reached(), 1U);
  EXPECT_EQ(missed(), 0U);
  end();
  go_to(2, 0);
  send("M400");
  EXPECT_EQ(reached(), 2U);
  EXPECT_EQ(missed(), 0U);
}

TEST_F(PointCheckTest, does_not_miss_what_is_still_under_way) {
  send("G28 X Y");
  send("G1 X10");
  send("G1 X20");
  go_to(15, 0);
  EXPECT_EQ(reached(), 1U);
  EXPECT_EQ(missed(), 0U);
}

}  // namespace
