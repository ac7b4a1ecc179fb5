// SPDX-License-Identifier: Apache-2.0
// M290 while linear advance is on: Z moves at once or with the next line in X and Y.
#include "tests/sim/point_check_fixture.hpp"

namespace {

report::MachineFacts facts() {
  report::MachineFacts all;
  all.shaping.emplace().advance_us = 1000;
  return all;
}

class ShapedBabystep : public tests::PointCheckTest {
 protected:
  ShapedBabystep() : PointCheckTest(facts()) {
    send("G28");
    send("G1 X10 F60000");
    go_to(10, 0);
  }
  // A tenth of a millimetre, or another distance.
  void lift(std::int64_t way = 256) { go_to(position[0], position[1], position[2] + way, 0); }
  void finish() { send("M400"); }
  void expect_good() {
    finish();
    EXPECT_EQ(missed(), 0);
    EXPECT_EQ(unasked(), report::Steps{});
  }
};

// The host has sent the next line by then.
TEST_F(ShapedBabystep, may_be_made_at_once) {
  send("M290 Z0.1");
  begin("G1 X20");
  lift();
  end();
  go_to(20, 0);
  expect_good();
}

TEST_F(ShapedBabystep, may_go_along_with_the_next_line) {
  send("M290 Z0.1");
  send("G1 X20");
  go_to(steps(0, 20), 0, 256, 0);
  expect_good();
}

TEST_F(ShapedBabystep, may_be_made_while_the_host_sends_nothing_or_asks_for_temperatures) {
  send("M290 Z0.1");
  lift();
  EXPECT_EQ(missed(), 0);
  send("M400");
  send("G1 X20");
  go_to(steps(0, 20), 0, 256, 0);
  send("M290 Z0.1");
  send("M105");
  lift();
  expect_good();
}

TEST_F(ShapedBabystep, may_be_the_last_motion_of_a_file) {
  send("M290 Z0.1");
  for (int step = 1; step <= 256; ++step) {
    lift(1);
    EXPECT_EQ(missed(), 0);
    if (step == 256) {
      EXPECT_FALSE(check.judgement().moved_after_end[2]);
    }
  }
  EXPECT_EQ(unasked(), report::Steps{});
}

// The shaper is late: the next line is answered before Z moves.
TEST_F(ShapedBabystep, may_be_made_at_once_after_the_answer_to_the_next_line) {
  send("M290 Z0.1");
  send("G1 X20 Z-0.05");
  lift();
  go_to(steps(0, 20), 0, 128, 0);
  expect_good();
}

TEST_F(ShapedBabystep, is_made_at_once_where_the_chip_rests) {
  finish();
  send("M290 Z0.1");
  send("G1 Z5");
  lift();
  go_to(position[0], 0, steps(2, 5.1), 0);
  clock += 4'000'000;
  send("M290 Z0.1");
  send("G1 Z6");
  lift();
  go_to(position[0], 0, steps(2, 6.2), 0);
  expect_good();
}

TEST_F(ShapedBabystep, leaves_homing_free) {
  send("M290 Z0.1");
  begin("G28 Z");
  lift(100);
  lift(-100);
  end();
  send("G1 X20");
  go_to(20, 0);
  expect_good();
}

TEST_F(ShapedBabystep, is_missed_where_z_comes_back) {
  send("M290 Z0.1");
  lift();
  lift(-256);
  send("G1 X20");
  go_to(20, 0);
  finish();
  EXPECT_GT(missed(), 0);
}

TEST_F(ShapedBabystep, is_missed_where_z_goes_too_far) {
  send("M290 Z0.1");
  lift(512);
  send("G1 X20");
  go_to(steps(0, 20), 0, 512, 0);
  finish();
  EXPECT_GT(missed(), 0);
}

TEST_F(ShapedBabystep, is_missed_where_the_next_line_alone_ends_a_step_off) {
  send("M290 Z0.1");
  send("G1 X20");
  go_to(steps(0, 20), 0, 255, 0);
  finish();
  EXPECT_GT(missed(), 0);
}

TEST_F(ShapedBabystep, is_missed_where_z_stays_or_goes_elsewhere) {
  send("M290 Z0.1");
  send("G1 X20");
  go_to(20, 0);
  finish();
  EXPECT_GT(missed(), 0);
}

TEST_F(ShapedBabystep, is_missed_where_it_ends_a_step_off) {
  send("M290 Z0.1");
  lift(255);
  finish();
  EXPECT_GT(missed(), 0);
}

}  // namespace
