// SPDX-License-Identifier: Apache-2.0
// The planner with a step generator behind it: exactness, limits, look-ahead, when motion starts.
#include "motion/planner.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <random>

#include "motion/steps.hpp"
#include "tests/motion/machine.hpp"
#include "tests/motion/print_run.hpp"

namespace {

using motion::LineMove;
using motion_test::at;
using motion_test::mendel;
using motion_test::PrintRun;
using motion_test::RunOptions;
using motion_test::RunResult;
using units::MicrometersPerSecond;
using units::Microseconds;

constexpr std::int64_t mm = 1'000'000;

LineMove to(std::int64_t x, std::int64_t y, std::int64_t z, std::int64_t e, std::int32_t um_s) {
  return {.target = at(x, y, z, e), .feedrate = MicrometersPerSecond(um_s)};
}

void expect_exact_and_within_limits(const RunResult& result) {
  EXPECT_EQ(result.wrong_line_ends, 0u);
  EXPECT_EQ(result.underruns, 0u);
  // A line's ends are rounded by up to half a step, and its steps come up to 3/4 early or late.
  EXPECT_LE(result.worst_deviation_steps, 1.25);
  EXPECT_LE(result.worst_distance_steps, std::numbers::sqrt2);
  EXPECT_LE(result.worst_speed_excess, 1e-5);
  EXPECT_LE(result.worst_acceleration_excess, 1e-5);
  EXPECT_LE(result.worst_jump_excess_mm_s, 1e-3);
}

// Coordinates are rounded as a slicer writes them, or as given.
std::vector<LineMove> arc(int segments, double length_mm, double radius_mm, std::int32_t um_s,
                          std::int64_t resolution_nm = 1'000) {
  std::vector<LineMove> moves;
  for (int i = 1; i <= segments; ++i) {
    const double angle = i * length_mm / radius_mm;
    const double unit = 1e6 / static_cast<double>(resolution_nm);
    const auto x = std::llround(radius_mm * std::sin(angle) * unit) * resolution_nm;
    const auto y = std::llround(radius_mm * (1 - std::cos(angle)) * unit) * resolution_nm;
    moves.push_back(to(x, y, 0, 0, um_s));
  }
  return moves;
}

TEST(planner, makes_the_steps_of_a_single_move_and_rests) {
  PrintRun run(mendel(), {});
  const RunResult result = run.run({to(100 * mm, 50 * mm, 0, 0, 100'000)});
  EXPECT_THAT(result.final_steps, testing::ElementsAre(8'000, 4'000, 0, 0));
  EXPECT_EQ(result.segments, 3u);
  // At 100 mm/s; each ramp costs (v - v0)^2 / 2 a v: it starts with a jerk of 10 mm/s on X and ends
  // with the speed in the middle of its last step.
  const double last = std::sqrt(1'500 * std::hypot(100, 50) / 8'000);
  const double ramps = std::pow(100 - 11.18, 2) + std::pow(100 - last, 2);
  EXPECT_NEAR(result.seconds, std::hypot(100, 50) / 100 + ramps / (2 * 1'500 * 100), 0.0005);
  expect_exact_and_within_limits(result);
}

TEST(planner, reaches_full_speed_on_tiny_segments) {
  motion::Limits limits = mendel();
  limits.travel_acceleration = units::MicrometersPerSecondSquared(3'000'000);
  PrintRun run(limits, {});
  const RunResult result = run.run(arc(1'200, 0.2, 20, 200'000));
  expect_exact_and_within_limits(result);
  EXPECT_EQ(result.rests, 1u);
  EXPECT_LT(result.seconds, 1.30);  // ideal: 1.267
  RecordProperty("seconds", std::to_string(result.seconds));
  std::printf("arc of 1200 segments: %.3f s, top %.1f mm/s\n", result.seconds,
              result.highest_speed_mm_s);
}

TEST(planner, slows_down_but_does_not_stop_when_lines_come_too_slowly) {
  motion::Limits limits = mendel();
  limits.travel_acceleration = units::MicrometersPerSecondSquared(3'000'000);
  PrintRun run(limits, {.lines_per_second = 500});
  const RunResult result = run.run(arc(1'200, 0.2, 20, 200'000));
  expect_exact_and_within_limits(result);
  std::printf("the same at 500 lines/s: %.3f s, %lu rests\n", result.seconds, result.rests);
  EXPECT_LE(result.rests, 1u);
}

TEST(planner, keeps_the_queue_filled_when_it_is_called_seldom) {
  PrintRun run(mendel(), {.queue_depth = 32, .refill_seconds = 0.02});
  const RunResult result = run.run(arc(600, 0.2, 20, 150'000));
  expect_exact_and_within_limits(result);
  EXPECT_EQ(result.rests, 1u);
}

TEST(planner, stops_at_every_corner_without_jerk) {
  motion::Limits limits = mendel();
  for (motion::AxisLimits& axis : limits.axes) axis.jerk = {};
  PrintRun run(limits, {});
  const RunResult result =
      run.run({to(10 * mm, 0, 0, mm, 50'000), to(10 * mm, 10 * mm, 0, mm, 50'000),
               to(0, 10 * mm, 0, mm, 50'000), to(0, 0, 0, 0, 50'000)});
  expect_exact_and_within_limits(result);
  EXPECT_EQ(result.rests, 1u);
  EXPECT_NEAR(result.seconds, 4 * (10.0 / 50 + 50.0 / 1'500), 0.03);
}

class RandomMoves : public testing::TestWithParam<std::uint32_t> {};

TEST_P(RandomMoves, are_exact_and_keep_every_limit) {
  std::mt19937_64 random(GetParam());
  const auto within = [&](std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(random);
  };
  motion::Limits limits = mendel();
  limits.of(units::Axis::x).steps_per_meter = units::StepsPerMeter(62'745);
  PrintRun run(limits, {.clock_hz = GetParam()});
  std::vector<LineMove> moves;
  std::int64_t x = 0, y = 0, z = 0, e = 0;
  const int count = GetParam() > 20'000'000 ? 60 : 400;
  for (int i = 0; i < count; ++i) {
    const std::int64_t reach = i % 3 == 0 ? 20'000 : i % 3 == 1 ? 500'000 : 10 * mm;
    if (within(0, 9) != 0) x += within(-reach, reach);
    if (within(0, 9) != 0) y += within(-reach, reach);
    if (within(0, 19) == 0) z += within(-reach / 10, reach / 10);
    if (within(0, 4) != 0) e += within(-reach / 20, reach / 10);
    moves.push_back(to(x, y, z, e, static_cast<std::int32_t>(within(1'000, 300'000))));
  }
  const RunResult result = run.run(moves);
  expect_exact_and_within_limits(result);
  EXPECT_LE(result.worst_rate_mismatch, 0.01);
  std::printf("worst: %.3f steps, rates of phases %.2e, speed %.2e, acceleration %.2e\n",
              result.worst_deviation_steps, result.worst_rate_mismatch, result.worst_speed_excess,
              result.worst_acceleration_excess);
}

INSTANTIATE_TEST_SUITE_P(clocks, RandomMoves,
                         testing::Values(4'000'000, 4'915'200, 12'345'678, 50'000'000,
                                         100'000'000));

TEST(planner, starts_a_long_move_at_once_and_a_short_one_after_the_delay) {
  motion::Planner planner(mendel(), motion_test::timing(4'000'000));
  ASSERT_TRUE(planner.append(to(20 * mm, 0, 0, 0, 50'000), Microseconds(5)));
  EXPECT_TRUE(planner.next_segment(Microseconds(5)));

  motion::Planner other(mendel(), motion_test::timing(4'000'000));
  ASSERT_TRUE(other.append(to(1 * mm, 0, 0, 0, 50'000), Microseconds(5)));
  EXPECT_FALSE(other.next_segment(Microseconds(100'000)));
  EXPECT_TRUE(other.next_segment(Microseconds(100'005)));
}

TEST(planner, starts_at_once_when_flushed) {
  motion::Planner planner(mendel(), motion_test::timing(4'000'000));
  ASSERT_TRUE(planner.append(to(100'000, 0, 0, 0, 50'000), Microseconds(0)));
  EXPECT_FALSE(planner.next_segment(Microseconds(0)));
  planner.flush();
  std::optional<motion::Segment> last;
  while (const auto segment = planner.next_segment(Microseconds(0))) last = segment;
  ASSERT_TRUE(last);
  EXPECT_TRUE(last->ends_motion);
  EXPECT_TRUE(planner.empty());
}

TEST(planner, hands_over_no_more_than_the_horizon_needs) {
  motion::Planner planner(mendel(), motion_test::timing(4'000'000));
  for (const LineMove& move : arc(30, 1, 20, 50'000)) ASSERT_TRUE(planner.append(move, {}));
  planner.flush();
  int segments = 0;
  while (planner.next_segment({})) ++segments;
  EXPECT_GE(segments, 2);  // 20 ms each
  EXPECT_LE(segments, 6);
}

// Solves ticks = rate * t + acceleration / 2 * t^2.
double microseconds_of(const motion::Segment& segment, double clock_hz) {
  const double rate = std::ldexp(static_cast<double>(segment.rate), -64);
  const double acceleration = std::ldexp(static_cast<double>(segment.acceleration), -84);
  const double end_rate = std::sqrt(std::max(rate * rate + 2 * acceleration * segment.ticks, 0.0));
  return 2 * segment.ticks / (rate + end_rate) / clock_hz * 1e6;
}

// Handed over, the lines in which it would brake at the end of the ring could not become faster.
TEST(planner, hands_over_no_more_than_it_keeps_to_plan_with) {
  constexpr int clock_hz = 50'000'000;
  motion::StepTiming timing = motion_test::timing(clock_hz);
  timing.longest_pass = Microseconds(3'000);
  motion::Planner planner(mendel(), timing);
  for (std::int64_t x = 50'000; planner.has_room(); x += 50'000) {
    ASSERT_TRUE(planner.append(to(x, 0, 0, 0, 50'000), {}));  // 1 ms each at that speed
  }
  double handed_over = 0;
  const auto hand_over = [&](int ms) {
    while (const auto segment = planner.next_segment(Microseconds(1'000 * ms))) {
      handed_over += microseconds_of(*segment, clock_hz);
    }
  };
  hand_over(0);
  EXPECT_GT(handed_over, timing.longest_pass.count());
  EXPECT_GE(planner.lines(), motion::Planner::capacity / 2 - 2);
  // With little left, what a pass of the program needs.
  for (int ms = 0; ms < 150; ms += 3) {
    hand_over(ms);
    EXPECT_TRUE(planner.empty() || handed_over >= 1'000 * ms + 2'990) << ms;
  }
  EXPECT_TRUE(planner.empty());
}

TEST(planner, collects_moves_of_less_than_a_step) {
  motion::Planner planner(mendel(), motion_test::timing(4'000'000));
  for (int i = 1; i <= 3; ++i) {
    ASSERT_TRUE(planner.append(to(2'000 * i, 0, 0, 0, 50'000), {}));
    EXPECT_EQ(planner.lines(), 0u);
  }
  ASSERT_TRUE(planner.append(to(8'000, 0, 0, 0, 50'000), {}));
  EXPECT_EQ(planner.lines(), 1u);
  EXPECT_EQ(planner.position_steps()[0], 1);
}

TEST(planner, keeps_the_feedrate_on_moves_of_less_than_a_step) {
  std::vector<LineMove> moves;
  for (int i = 1; i <= 1'000; ++i) moves.push_back(to(2'000 * i, 0, 0, 0, 10'000));
  PrintRun run(mendel(), {});
  const RunResult result = run.run(moves);
  expect_exact_and_within_limits(result);
  EXPECT_NEAR(result.seconds, 0.2, 0.004);
}

// X and Y step shortly after each other: every other line is a step in a sixth of a step's length.
TEST(planner, does_not_slow_down_where_rounding_puts_steps_close_together) {
  motion::Limits limits = mendel();
  limits.travel_acceleration = units::MicrometersPerSecondSquared(6'000'000);
  for (motion::AxisLimits& axis : limits.axes) axis.max_acceleration = limits.travel_acceleration;
  std::vector<LineMove> moves;
  for (int i = 1; i <= 5'000; ++i) moves.push_back(to(1'400 * i, 1'400 * i + 1'400, 0, 0, 100'000));
  PrintRun run(limits, {});
  const RunResult result = run.run(moves);
  expect_exact_and_within_limits(result);
  EXPECT_LT(result.seconds, 0.23);  // by look-ahead: 10 mm at 58 mm/s; 32 mm/s by the step rate
}

TEST(planner, does_not_crawl_where_steps_are_coarser_than_segments) {
  motion::Limits limits = mendel();
  limits.travel_acceleration = units::MicrometersPerSecondSquared(3'000'000);
  PrintRun run(limits, {});
  const RunResult result = run.run(arc(3'000, 0.005, 20, 60'000, 1));
  expect_exact_and_within_limits(result);
  // The ring looks 0.35 mm ahead, which permits 46 mm/s: 0.33 s.
  EXPECT_LT(result.seconds, 0.37);
}

TEST(planner, keeps_a_position_far_out_exact) {
  motion::Limits limits = mendel();
  PrintRun run(limits, {});
  const std::int64_t far = 5'000'000 * mm;  // 5 km of filament
  run.planner().set_position(at(0, 0, 0, far));
  motion::Planner& planner = run.planner();
  ASSERT_TRUE(planner.append(to(10 * mm, 0, 0, far + 1'234'567, 50'000), {}));
  EXPECT_EQ(
      planner.position_steps()[3],
      motion_test::exact_steps(units::Nanometers(far + 1'234'567), units::StepsPerMeter(500'000)));
}

TEST(planner, refuses_what_it_cannot_do_and_stays_as_it_was) {
  motion::Planner planner(mendel(), motion_test::timing(4'000'000));
  EXPECT_EQ(planner.append(to(mm, 0, 0, 0, 0), {}).error(), motion::Fault::feedrate_out_of_range);
  EXPECT_EQ(planner.append(to(mm, 0, 0, 0, -5), {}).error(), motion::Fault::feedrate_out_of_range);
  const std::int64_t beyond = motion::max_position.count() + 1;
  EXPECT_EQ(planner.append(to(beyond, 0, 0, 0, 1), {}).error(), motion::Fault::target_out_of_range);
  EXPECT_EQ(planner.append(to(INT64_MIN, 0, 0, 0, 1), {}).error(),
            motion::Fault::target_out_of_range);
  EXPECT_EQ(planner.append(to(0, 0, 0, 10'000'000 * mm, 1), {}).error(),
            motion::Fault::line_too_long);
  EXPECT_TRUE(planner.empty());
  std::int64_t x = 0;
  while (planner.has_room()) ASSERT_TRUE(planner.append(to(x += mm, 0, 0, 0, 50'000), {}));
  EXPECT_EQ(planner.append(to(0, 0, 0, 0, 50'000), {}).error(), motion::Fault::queue_full);
  EXPECT_EQ(planner.lines(), motion::Planner::capacity);
  EXPECT_EQ(planner.position()[0].whole().count(), x);
}

TEST(planner, forgets_everything_when_cleared) {
  motion::Planner planner(mendel(), motion_test::timing(4'000'000));
  for (const LineMove& move : arc(30, 1, 20, 50'000)) ASSERT_TRUE(planner.append(move, {}));
  planner.flush();
  ASSERT_TRUE(planner.next_segment({}));
  planner.clear();
  planner.set_position_steps({80, 160, 0, -500});
  EXPECT_TRUE(planner.empty());
  EXPECT_FALSE(planner.next_segment(Microseconds(1'000'000)));
  EXPECT_EQ(planner.position(), at(1 * mm, 2 * mm, 0, -1 * mm));
}

}  // namespace
