// SPDX-License-Identifier: Apache-2.0
// Where the steps of a line begin: the rule, and how near to the exact line it keeps the path.
#include "motion/line_start.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

namespace {

using motion::LineStart;
using motion::StepParts;
using units::Axis;

// Numbers of X and Y.
using Pair = std::array<double, 2>;

StepParts parts(double steps) {
  return StepParts(static_cast<std::int32_t>(std::lround(steps * motion::one_step.count())));
}

// Residuals in steps, at the start and the end together.
LineStart start_of(std::int32_t x, std::int32_t y, std::uint32_t ticks, Pair residual) {
  return motion::line_start({x, y, 0, 0}, ticks, {parts(residual[0]), parts(residual[1])});
}

// -1 behind, 0, or 1 ahead, of X and Y; the others are never shifted.
std::array<int, 2> shifts(const LineStart& start) {
  EXPECT_FALSE(start.ahead.contains(Axis::z) || start.behind.contains(Axis::z));
  EXPECT_FALSE(start.ahead.contains(Axis::e) || start.behind.contains(Axis::e));
  const auto shift = [&](Axis axis) {
    EXPECT_FALSE(start.ahead.contains(axis) && start.behind.contains(axis));
    return (start.ahead.contains(axis) ? 1 : 0) - (start.behind.contains(axis) ? 1 : 0);
  };
  return {shift(Axis::x), shift(Axis::y)};
}

using Shifts = std::array<int, 2>;

TEST(line_start, is_in_the_middle_where_nothing_is_rounded) {
  EXPECT_EQ(shifts(start_of(100, 30, 100, {0, 0})), (Shifts{0, 0}));
  EXPECT_EQ(shifts(start_of(0, 0, 100, {0.9, 0.9})), (Shifts{0, 0}));
}

TEST(line_start, shifts_the_slower_of_x_and_y_towards_the_exact_line) {
  EXPECT_EQ(shifts(start_of(100, 30, 100, {0, 0.26})), (Shifts{0, 1}));
  EXPECT_EQ(shifts(start_of(100, 30, 100, {0, 0.24})), (Shifts{0, 0}));
  EXPECT_EQ(shifts(start_of(100, 30, 100, {0, -0.26})), (Shifts{0, -1}));
  EXPECT_EQ(shifts(start_of(-100, 30, 100, {0, 0.26})), (Shifts{0, 1}));
  EXPECT_EQ(shifts(start_of(100, -30, 100, {0, 0.26})), (Shifts{0, -1}));
  EXPECT_EQ(shifts(start_of(-100, -30, 100, {0, -0.26})), (Shifts{0, 1}));
  EXPECT_EQ(shifts(start_of(30, -100, 100, {0.26, 0})), (Shifts{1, 0}));
  EXPECT_EQ(shifts(start_of(30, -100, 100, {-0.26, 0})), (Shifts{-1, 0}));
}

TEST(line_start, knows_that_a_shift_along_the_line_is_none) {
  EXPECT_EQ(shifts(start_of(100, 100, 100, {1, 1})), (Shifts{0, 0}));
  EXPECT_EQ(shifts(start_of(100, -50, 100, {1, -0.5})), (Shifts{0, 0}));
  EXPECT_EQ(shifts(start_of(100, 50, 100, {-1, 0})), (Shifts{0, 1}));
  EXPECT_EQ(shifts(start_of(100, 50, 100, {1, 0})), (Shifts{0, -1}));
  EXPECT_EQ(shifts(start_of(-100, 50, 100, {1, 0})), (Shifts{0, 1}));
}

TEST(line_start, shifts_both_where_neither_steps_at_every_tick) {
  EXPECT_EQ(shifts(start_of(100, 30, 101, {0.3, -0.3})), (Shifts{1, -1}));
  EXPECT_EQ(shifts(start_of(-100, 30, 101, {0.3, 0.3})), (Shifts{-1, 1}));
  EXPECT_EQ(shifts(start_of(100, 0, 101, {0.2, 0.3})), (Shifts{0, 0}));
}

TEST(line_start, takes_the_longest_line) {
  constexpr std::int32_t longest = 0x7FFF'FFFF;
  EXPECT_EQ(shifts(start_of(longest, -longest, longest, {1, -0.7})), (Shifts{0, -1}));
  EXPECT_EQ(shifts(start_of(-longest, -longest, longest, {-1, 0.9})), (Shifts{0, -1}));
  EXPECT_EQ(shifts(start_of(longest, longest, longest, {-1, -0.8})), (Shifts{0, 0}));
}

struct Line {
  Pair from, to;
  std::uint32_t ticks;

  std::int32_t steps(std::size_t axis) const {
    return static_cast<std::int32_t>(std::lround(to[axis]) - std::lround(from[axis]));
  }
  double residual(std::size_t axis) const {
    return from[axis] - std::round(from[axis]) + to[axis] - std::round(to[axis]);
  }
};

// The largest distance from the exact line at any tick.
double worst_distance(const Line& line, Shifts shift) {
  const Pair way{line.to[0] - line.from[0], line.to[1] - line.from[1]};
  const double length = std::hypot(way[0], way[1]);
  double worst = 0;
  for (std::uint32_t tick = 1; tick <= line.ticks; ++tick) {
    Pair gone{};
    for (std::size_t i = 0; i < 2; ++i) {
      const std::uint32_t start = shift[i] > 0   ? line.ticks / 2 + line.ticks / 4
                                  : shift[i] < 0 ? line.ticks / 4
                                                 : line.ticks / 2;
      const auto size = static_cast<std::uint32_t>(std::abs(line.steps(i)));
      const double count = (tick * size + start) / line.ticks;
      gone[i] = std::round(line.from[i]) + (line.steps(i) < 0 ? -count : count) - line.from[i];
    }
    worst = std::max(worst, std::abs(way[0] * gone[1] - way[1] * gone[0]) / length);
  }
  return worst;
}

// Of random lines, shifted as the rule has it and not at all.
struct Distances {
  double worst{};
  int beyond_a_step{}, beyond_a_step_unshifted{};
};

Distances walk_random_lines(bool led_by_x_or_y) {
  std::mt19937 random(7);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  Distances result;
  for (int i = 0; i < 20'000; ++i) {
    const double reach = i % 3 == 0 ? 3 : i % 3 == 1 ? 10 : 40;
    Line line{.from = {uniform(-5, 5), uniform(-5, 5)}, .to = {}, .ticks = 0};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      line.to[axis] = line.from[axis] + uniform(-reach, reach);
      line.ticks = std::max(line.ticks, static_cast<std::uint32_t>(std::abs(line.steps(axis))));
    }
    if (line.ticks == 0) continue;
    if (!led_by_x_or_y) line.ticks += static_cast<std::uint32_t>(1 + random() % 40);
    const Shifts shift = shifts(
        start_of(line.steps(0), line.steps(1), line.ticks, {line.residual(0), line.residual(1)}));
    const double distance = worst_distance(line, shift);
    result.worst = std::max(result.worst, distance);
    if (distance > 1) ++result.beyond_a_step;
    if (worst_distance(line, {}) > 1) ++result.beyond_a_step_unshifted;
  }
  std::printf("%s: %.3f steps at worst, beyond a step %d lines of 20000, %d unshifted\n",
              led_by_x_or_y ? "X or Y leads" : "neither leads", result.worst, result.beyond_a_step,
              result.beyond_a_step_unshifted);
  return result;
}

// No start helps a line whose ends are rounded to opposite sides by as much as can be: 1/2 step and
// (1 + slope) / 2, across a line of slope 1/2, are 1.118.
TEST(line_start, keeps_almost_every_line_led_by_x_or_y_within_a_step) {
  const Distances distances = walk_random_lines(true);
  EXPECT_LE(distances.worst, std::sqrt(1.25));
  EXPECT_LT(distances.beyond_a_step, 20);
  EXPECT_GT(distances.beyond_a_step_unshifted, 10 * distances.beyond_a_step);
}

// X and Y are rounded each on its own: up to a step off each at the same time.
TEST(line_start, keeps_most_other_lines_within_a_step) {
  const Distances distances = walk_random_lines(false);
  EXPECT_LE(distances.worst, std::sqrt(2));
  EXPECT_LT(distances.beyond_a_step, 200);
  EXPECT_GT(distances.beyond_a_step_unshifted, 3 * distances.beyond_a_step);
}

}  // namespace
