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

TEST_F(ShapedBounds, misses_filament_that_goes_faster_than_m203_or_m207_says) {
  std::uint64_t before = 0;
  send("M207 F600");
  send("M83");
  for (const bool by_code : {false, true}) {
    send(by_code ? "M203 E100" : "M203 E10");
    for (const int clocks_per_step : {800, 400}) {  // 10 mm/s, 20 mm/s
      send(by_code ? "G10" : "G1 E-3 F6000");
      for (int i = 0; i < 1500; ++i) {
        clock += static_cast<std::uint64_t>(clocks_per_step);
        step(3, -1);
      }
      send("M400");
      EXPECT_EQ(missed() - before, clocks_per_step < 800 ? 1 : 0) << by_code;
      if (by_code) send("G11");
      if (by_code) go_to(position[0], position[1], 0, position[3] + 1500);
      send("M400");
      before = missed();
    }
  }
}

TEST_F(ShapedBounds, misses_advance_of_a_speed_that_m203_forbids) {
  send("M900 K0.1");
  send("M203 E5");
  for (const int ahead_steps : {250, 1000}) {  // 0.5 mm, as 5 mm/s make, and 2 mm
    send("G91");
    send("G1 X100 E20 F12000");
    const auto e = position[3];
    for (int i = 1; i <= 8000; ++i) {
      clock += 2000;
      step(0, 1);
      const int ahead = i < 7000 ? std::min(i, ahead_steps) : std::max(0, ahead_steps - (i - 7000));
      while (position[3] < e + i * 10'000 / 8000 + ahead) step(3, 1);
      while (position[3] > e + i * 10'000 / 8000 + ahead) step(3, -1);
    }
    send("M400");
    EXPECT_EQ(missed(), ahead_steps > 250 ? 1 : 0) << ahead_steps;
  }
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
