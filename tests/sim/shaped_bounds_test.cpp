// SPDX-License-Identifier: Apache-2.0
// A shaped print of any length, also one that never rests or is lost, is judged step by step.
#include <fmt/format.h>

#include "point_check_fixture.hpp"

namespace tests {

namespace {

report::MachineFacts shaped_facts() {
  report::MachineFacts facts;
  facts.shaping = report::ShapingSetting();
  for (report::ShaperSetting& shaper : facts.shaping->shapers) {
    shaper = {report::ShaperKind::ei, 30'000};
  }
  return facts;
}

constexpr int many = 100'000;

class ShapedBounds : public PointCheckTest {
 protected:
  ShapedBounds() : PointCheckTest(shaped_facts()) { send("G1 F3000"); }
  void go_on(int steps) {
    for (int i = 0; i < steps; ++i) {
      clock += 2000;
      step(0, 1);
    }
  }
};

}  // namespace

TEST_F(ShapedBounds, judges_many_lines_without_a_rest) {
  for (int line = 1; line <= many; ++line) {
    send(fmt::format("G1 X{:.2f}", line * 0.05));
    if (line > 20) go_on(4);
  }
  go_on(80);
  EXPECT_EQ(missed(), 0);
  EXPECT_EQ(reached(), many);
}

TEST_F(ShapedBounds, misses_all_lines_where_it_never_comes_near_again) {
  go_to(1234, 20'000, 0, 0);
  for (int line = 1; line <= many; ++line) {
    send(fmt::format("G1 X{:.2f}", line * 0.05));
    go_on(4);
  }
  send("M400");
  EXPECT_EQ(missed(), many);
  EXPECT_EQ(reached(), 0);
}

TEST_F(ShapedBounds, misses_all_lines_where_it_stands_still) {
  for (int line = 1; line <= many; ++line) send(fmt::format("G1 X{:.2f}", line * 0.05));
  EXPECT_GE(missed(), many - 1024) << "old lines are kept";
  send("M400");
  EXPECT_EQ(missed(), many);
}

TEST_F(ShapedBounds, reaches_lines_with_no_motion_at_once) {
  send("G1 X1");
  go_on(80);
  for (int line = 0; line < many; ++line) send("G1 X1");
  EXPECT_EQ(reached(), many + 1);
}

TEST_F(ShapedBounds, counts_steps_that_nothing_asks_for_between_rests) {
  send("G1 X1");
  go_on(80);
  send("M400");
  for (const int direction : {1, -1}) {
    clock += 2000;
    step(1, direction);
  }
  send("M400");
  EXPECT_EQ(unasked()[1], 2);
}

TEST_F(ShapedBounds, counts_steps_that_nothing_asks_for_before_the_file_ends) {
  send("G1 X1");
  go_on(40);
  for (const int direction : {1, -1}) {
    clock += 2000;
    step(1, direction);
  }
  go_on(40);
  EXPECT_EQ(unasked()[1], 2);
}

TEST_F(ShapedBounds, misses_a_straight_line_that_is_made_twice_as_fast_as_it_says) {
  send("G1 X50");
  for (int i = 0; i < 4000; ++i) {
    clock += 500;  // 100 mm/s
    step(0, 1);
  }
  EXPECT_EQ(missed(), 1);
}

}  // namespace tests
