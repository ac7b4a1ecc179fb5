// SPDX-License-Identifier: Apache-2.0
// Whole lines with ramps of third order: limits, exact steps, and a queue that does not run empty.
#include <gtest/gtest.h>

#include <deque>
#include <random>

#include "motion/planner.hpp"
#include "motion/s_curve.hpp"
#include "tests/motion/machine.hpp"
#include "tests/motion/print_run.hpp"
#include "tests/motion/segment_run.hpp"

namespace {

using motion::LineMove;
using motion_test::at;
using motion_test::run_segments;

constexpr std::uint32_t clock_hz = 50'000'000;

motion::Limits curved(std::int64_t deviation_nm = 0) {
  motion::Limits limits = motion_test::mendel();
  limits.junction_deviation = units::Nanometers(deviation_nm);
  limits.s_curve = true;
  return limits;
}

std::vector<LineMove> random_moves(std::mt19937_64& random, std::size_t count) {
  const auto within = [&](std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(random);
  };
  std::vector<LineMove> moves;
  units::PerAxis<std::int64_t> place{};
  const std::int64_t reach = std::int64_t{10'000} << within(0, 11);
  while (moves.size() < count) {
    place[0] += within(-reach, reach);
    place[1] += within(-reach, reach);
    if (within(0, 9) == 0) place[2] += within(-reach / 10, reach / 10);
    if (within(0, 1) == 0) place[3] += within(0, reach / 20);
    moves.push_back({.target = at(place[0], place[1], place[2], place[3]),
                     .feedrate = units::MicrometersPerSecond(
                         static_cast<std::int32_t>(within(5'000, 250'000)))});
  }
  return moves;
}

TEST(s_curve_planner, exceeds_no_limit_and_ends_at_the_step) {
  std::mt19937_64 random(1);
  double speed = -1, acceleration = -1, jump = -1;
  std::uint64_t third_order = 0;
  for (int i = 0; i < 10'000; ++i) {
    const motion::Limits limits = curved(i % 2 == 0 ? 20'000 : 0);
    const auto moves = random_moves(random, 12);
    const auto run = run_segments(limits, moves, clock_hz);
    speed = std::max(speed, run.worst_speed);
    acceleration = std::max(acceleration, run.worst_acceleration);
    if (i % 2 != 0) jump = std::max(jump, run.worst_jump);
    third_order += run.third_order;
    for (std::size_t axis = 0; axis < units::axis_count; ++axis) {
      ASSERT_EQ(run.steps[axis], motion_test::exact_steps(moves.back().target[axis],
                                                          limits.axes[axis].steps_per_meter));
    }
  }
  std::printf("worst: speed %+.1e, acceleration %+.1e, jump %+.1e; %lu segments with a jerk\n",
              speed, acceleration, jump, third_order);
  EXPECT_LE(speed, 1e-4);
  EXPECT_LE(acceleration, 1e-4);
  EXPECT_LE(jump, 1e-4);
  // The limits are used.
  EXPECT_GE(speed, -1e-3);
  EXPECT_GE(acceleration, -1e-2);
  EXPECT_GT(third_order, 10'000u);
}

// By the model of the step generator, clock by clock: each line ends at its steps, and phases and
// lines begin with the rate that the one before ended with.
TEST(s_curve_planner, prints_to_the_step_without_an_underrun) {
  std::mt19937_64 random(2);
  double mismatch = 0;
  for (int i = 0; i < 6; ++i) {
    const auto moves = random_moves(random, 60);
    motion_test::PrintRun run(
        curved(20'000),
        {.clock_hz = 4'000'000, .queue_depth = 32, .least_line_time = units::Microseconds(4'000)});
    const auto result = run.run(moves);
    EXPECT_EQ(result.underruns, 0u);
    EXPECT_EQ(result.wrong_line_ends, 0u);
    EXPECT_LE(result.worst_speed_excess, 1e-4);
    mismatch = std::max(mismatch, result.worst_rate_mismatch);
  }
  std::printf("rates of phases %.1e\n", mismatch);
  EXPECT_LE(mismatch, 0.02);
}

// What the firmware relies on (motion_task): 30 segments outlast 160 000 clocks.
TEST(s_curve_planner, fills_the_queue_with_enough_time_whatever_the_lines) {
  std::mt19937_64 random(3);
  constexpr std::int64_t least_line_us = 320;
  double least = 1e9;
  for (int i = 0; i < 300; ++i) {
    motion::Planner planner(curved(i % 2 == 0 ? 20'000 : 0),
                            motion_test::timing(clock_hz, units::Microseconds(least_line_us)));
    const auto moves = random_moves(random, 300);
    std::deque<double> seconds;
    std::size_t fed = 0;
    units::Microseconds now;
    while (fed < moves.size() || !planner.empty()) {
      while (fed < moves.size() && planner.has_room()) {
        ASSERT_TRUE(planner.append(moves[fed++], {}).has_value());
      }
      planner.flush();
      const auto segment = planner.next_segment(now);
      if (!segment) {
        now += units::Microseconds(1'000);
        continue;
      }
      if (!segment->continues_line && segment->ends_motion) continue;
      seconds.push_back(motion_test::seconds_of(*segment, clock_hz));
      if (seconds.size() < 30) continue;
      double sum = 0;
      for (const double each : seconds) sum += each;
      least = std::min(least, sum);
      seconds.pop_front();
    }
  }
  std::printf("30 segments last %.0f clocks at least\n", least * clock_hz);
  EXPECT_GE(least * clock_hz, 160'000);
}

TEST(s_curve_planner, forgets_the_second_half_of_a_ramp_after_a_stop) {
  motion::Planner planner(curved(), motion_test::timing(clock_hz));
  const auto append = [&](std::int64_t x) {
    ASSERT_TRUE(planner.append(
        {.target = at(x, 0, 0, 0), .feedrate = units::MicrometersPerSecond(100'000)}, {}));
    planner.flush();
  };
  append(50'000'000);
  const auto first = planner.next_segment({});
  ASSERT_TRUE(first && first->jerk > 0);
  EXPECT_FALSE(planner.between_halves());
  EXPECT_FALSE(planner.between_lines());
  planner.clear();
  planner.set_position({});
  append(60'000'000);
  std::vector<motion::Segment> segments;
  while (const auto segment = planner.next_segment({})) segments.push_back(*segment);
  ASSERT_EQ(segments.size(), 5u);
  std::uint64_t ticks = 0;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    ticks += segments[i].ticks;
    EXPECT_EQ(segments[i].continues_line, i > 0);
    EXPECT_EQ(segments[i].ends_motion, i == 4);
    EXPECT_EQ(segments[i].steps[0], 4'800);
  }
  EXPECT_EQ(ticks, 4'800u);
}

TEST(s_curve_planner, takes_the_time_of_half_the_acceleration) {
  motion::Limits half = motion_test::mendel();
  half.travel_acceleration = units::MicrometersPerSecondSquared(750'000);
  const std::vector<LineMove> moves{
      {.target = at(100'000'000, 0, 0, 0), .feedrate = units::MicrometersPerSecond(100'000)}};
  const double curve = run_segments(curved(), moves, clock_hz).seconds;
  // Of a ramp of 533 ticks the apex is up to a tick late.
  EXPECT_NEAR(curve, run_segments(half, moves, clock_hz).seconds, 4e-4);
  EXPECT_GT(curve, run_segments(motion_test::mendel(), moves, clock_hz).seconds + 0.01);
}

}  // namespace
