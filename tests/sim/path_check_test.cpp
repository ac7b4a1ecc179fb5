// SPDX-License-Identifier: Apache-2.0
// The judge of the path: right edges pass to the step, wrong ones are told.
#include "sim/report/path_check.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace {

using devices::StepEdge;

// An ideal printer: walks each command's line with single steps along the ideal positions.
class PathCheckTest : public testing::Test {
 protected:
  static constexpr double steps_per_mm = 80;

  void send(const std::string& command, bool executed = true) {
    check.command_sent(0, 1, command);
    if (executed && command.starts_with("G28")) {
      go_to(0, 0);
    }
    check.command_acknowledged(0, 1, command, executed);
  }
  void step(std::size_t axis, int direction) {
    position[axis] += direction;
    check.stepped({clock, axis, direction, position[axis]});
  }
  // In small steps along the line, like a Bresenham walk.
  void go_to(double x_mm, double y_mm) {
    const std::array<std::int64_t, 2> from = position, to{std::llround(x_mm * steps_per_mm),
                                                          std::llround(y_mm * steps_per_mm)};
    const std::int64_t ticks = std::max(std::abs(to[0] - from[0]), std::abs(to[1] - from[1]));
    for (std::int64_t tick = 1; tick <= ticks; ++tick) {
      ++clock;
      for (std::size_t axis = 0; axis < 2; ++axis) {
        const auto ideal =
            static_cast<double>((to[axis] - from[axis]) * tick) / static_cast<double>(ticks);
        const std::int64_t next = from[axis] + std::llround(ideal);
        if (next != position[axis]) {
          step(axis, next > position[axis] ? 1 : -1);
        }
      }
    }
  }

  std::array<std::int64_t, 2> position{1234, 567};
  std::uint64_t clock = 0;
  report::PathCheck check{{steps_per_mm, steps_per_mm}, {1234, 567}};
};

TEST_F(PathCheckTest, passes_a_path_that_keeps_to_the_lines) {
  send("G28");
  send("G1 X10.001 Y5.503 E1 F1200");
  send("G1 X20.3 Y5.503");
  send("G1 X20.3 Y7");
  go_to(10.001, 5.503);
  go_to(20.3, 5.503);
  go_to(20.3, 7);
  send("M400");
  EXPECT_EQ(check.points_missed(), 0U);
  EXPECT_EQ(check.points_reached(), 3U);
  EXPECT_LT(check.max_deviation_mm(), 1 / steps_per_mm);
  EXPECT_NEAR(check.length_mm(), std::hypot(10.001, 5.503) + (20.3 - 10.001) + (7 - 5.503), 1e-9);
}

TEST_F(PathCheckTest, tells_how_far_a_path_leaves_the_line) {
  send("G28");
  send("G1 X10 Y0");
  go_to(5, 0);
  go_to(5, 0.25);
  go_to(10, 0.25);
  go_to(10, 0);
  send("M400");
  EXPECT_NEAR(check.max_deviation_mm(), 0.25, 1e-9);
}

TEST_F(PathCheckTest, misses_a_point_that_the_edges_cut_off) {
  send("G28");
  send("G1 X10 Y0");
  send("G1 X10 Y10");
  go_to(9.95, 0);
  go_to(9.95, 10);
  go_to(10, 10);
  send("M400");
  EXPECT_EQ(check.points_missed(), 1U);
  EXPECT_EQ(check.points_reached(), 1U);
  EXPECT_NEAR(check.max_deviation_mm(), 0.05, 1e-9);
}

TEST_F(PathCheckTest, misses_the_end_where_steps_are_lost) {
  send("G28");
  send("G1 X10 Y0");
  go_to(8, 0);
  send("M400");
  EXPECT_EQ(check.points_missed(), 1U);
  EXPECT_NEAR(check.max_deviation_mm(), 2.0, 1e-9);
}

TEST_F(PathCheckTest, expects_nothing_of_a_refused_command) {
  send("G28");
  send("G1 X500", false);
  send("G1 X1");
  go_to(1, 0);
  send("M400");
  EXPECT_EQ(check.points_missed(), 0U);
  EXPECT_NEAR(check.length_mm(), 1.0, 1e-9);
}

TEST_F(PathCheckTest, understands_offsets_relative_moves_and_inches) {
  send("G28");
  send("G92 X100");
  send("G1 X101");
  send("G91");
  send("G1 X1 Y2");
  send("G20");
  send("G1 Y1");
  go_to(1, 0);
  go_to(2, 2);
  go_to(2, 27.4);
  send("M400");
  EXPECT_EQ(check.points_reached(), 3U);
  EXPECT_EQ(check.points_missed(), 0U);
}

TEST_F(PathCheckTest, checks_moves_before_homing_from_where_the_machine_stands) {
  send("G91");
  send("G1 X1");
  for (int i = 0; i < 80; ++i) {
    ++clock;
    step(0, 1);
  }
  send("M400");
  EXPECT_EQ(check.points_reached(), 1U);
  EXPECT_LT(check.max_deviation_mm(), 1e-9);
}

TEST_F(PathCheckTest, lets_a_second_homing_do_what_it_wants_after_the_moves_before_it) {
  send("G28");
  send("G1 X10 Y10");
  check.command_sent(0, 1, "G28 X0 Y0");
  go_to(10, 10);
  go_to(-0.0125, 10);
  go_to(2, 10);
  go_to(0, 0);
  check.command_acknowledged(0, 1, "G28 X0 Y0", true);
  send("G1 X1");
  go_to(1, 0);
  send("M400");
  EXPECT_EQ(check.points_missed(), 0U);
  EXPECT_LT(check.max_deviation_mm(), 1 / steps_per_mm);
}

}  // namespace
