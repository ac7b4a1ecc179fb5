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
