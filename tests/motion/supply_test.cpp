// SPDX-License-Identifier: Apache-2.0
// Lines that come too slowly, or that a slow processor cannot hand over fast enough: motion gets
// slower, the queue does not run dry, nothing stops and starts again.
#include "motion/supply.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/motion/machine.hpp"
#include "tests/motion/print_run.hpp"

namespace {

using motion::LineMove;
using motion::Stock;
using motion::Supply;
using motion_test::at;
using motion_test::PrintRun;
using motion_test::RunResult;
using units::MicrometersPerSecond;
using units::Microseconds;

Supply supply_with_interval(std::int64_t microseconds) {
  Supply supply;
  for (std::int64_t i = 0; i < 50; ++i) supply.line_came(Microseconds(i * microseconds));
  return supply;
}

Stock stock(std::size_t lines, std::int64_t microseconds) {
  return {.lines = lines, .time = Microseconds(microseconds), .resting = false};
}

TEST(supply, asks_for_nothing_before_an_interval_is_known) {
  Supply supply;
  EXPECT_EQ(supply.least_time(stock(0, 0)).count(), 0);
  supply.line_came(Microseconds(700'000));
  EXPECT_EQ(supply.least_time(stock(0, 0)).count(), 0);
}

TEST(supply, asks_for_nothing_while_there_is_enough) {
  const Supply supply = supply_with_interval(5'000);
  EXPECT_EQ(supply.least_time(stock(Supply::enough_lines, 3'000)).count(), 0);
  EXPECT_EQ(supply.least_time(stock(2, 100'000)).count(), 0);
}

TEST(supply, asks_for_the_interval_at_two_thirds_and_for_twice_of_it_below_a_third) {
  const Supply supply = supply_with_interval(5'000);
  EXPECT_EQ(supply.least_time(stock(16, 3'000)).count(), 5'000);
  EXPECT_EQ(supply.least_time(stock(8, 3'000)).count(), 10'000);
  EXPECT_EQ(supply.least_time(stock(0, 0)).count(), 10'000);
  // Few but long lines.
  EXPECT_NEAR(static_cast<double>(supply.least_time(stock(2, 67'000)).count()), 5'000, 700);
}

TEST(supply, asks_for_no_more_than_the_interval_before_motion_begins) {
  const Supply supply = supply_with_interval(5'000);
  Stock resting = stock(1, 2'000);
  resting.resting = true;
  EXPECT_EQ(supply.least_time(resting).count(), 5'000);
}

TEST(supply, forgets_the_interval_in_a_pause) {
  Supply supply = supply_with_interval(5'000);
  supply.line_came(Microseconds(10'000'000));
  EXPECT_EQ(supply.least_time(stock(0, 0)).count(), 0);
}

TEST(supply, never_slows_a_line_down_beyond_its_bound) {
  const Supply supply = supply_with_interval(90'000);
  EXPECT_EQ(supply.least_time(stock(0, 0)), Supply::longest);
}

LineMove to(double x_mm, double y_mm, std::int32_t um_s) {
  return {.target = at(std::llround(x_mm * 1e6), std::llround(y_mm * 1e6), 0, 0),
          .feedrate = MicrometersPerSecond(um_s)};
}

std::vector<LineMove> arc(int segments, double length_mm, std::int32_t um_s) {
  constexpr double radius = 20;
  std::vector<LineMove> moves;
  for (int i = 1; i <= segments; ++i) {
    const double angle = i * length_mm / radius;
    moves.push_back(to(radius * std::sin(angle), radius * (1 - std::cos(angle)), um_s));
  }
  return moves;
}

// Lines begin at speeds that differ by less than this factor, but for both ends of the motion.
double variation(const RunResult& result) {
  const auto& speeds = result.speeds_mm_s;
  const auto part = static_cast<std::ptrdiff_t>(speeds.size() / 5);
  const auto [least, most] = std::minmax_element(speeds.begin() + part, speeds.end() - part);
  return *most / *least;
}

TEST(supply, matches_the_speed_to_hosts_of_any_pace) {
  for (const double lines_per_second : {12.0, 28.0, 50.0, 100.0, 200.0, 330.0, 500.0, 800.0}) {
    const int lines = lines_per_second < 100 ? 150 : 600;
    PrintRun run(motion_test::mendel(), {.lines_per_second = lines_per_second});
    const RunResult result = run.run(arc(lines, lines_per_second < 100 ? 0.8 : 0.2, 150'000));
    EXPECT_EQ(result.underruns, 0u) << lines_per_second;
    // From the first line alone no interval is known.
    EXPECT_LE(result.rests, lines_per_second < 20 ? 2u : 1u) << lines_per_second;
    // Not slower than lines come, but for the start and the end.
    EXPECT_LT(result.seconds,
              std::max(lines / lines_per_second, lines * 0.2 / 150) + 0.3 + 3 / lines_per_second);
    std::printf("%4.0f lines/s: %.3f s, speeds within a factor of %.2f\n", lines_per_second,
                result.seconds, variation(result));
    // What the ring has collected before the start is executed at the speed requested, half as much
    // again as that of 500 lines/s.
    EXPECT_LT(variation(result), lines_per_second < 750 ? 1.75 : 2.5) << lines_per_second;
  }
}

// Slower than 10 ticks per second: each step in its time, and the next line in time.
TEST(supply, lets_very_slow_lines_last_as_long_as_they_should) {
  PrintRun run(motion_test::mendel(), {.refill_seconds = 0.01});
  const RunResult result =
      run.run({to(1, 0, 10'000), to(1.05, 0, 50), to(1.1, 0.05, 100), to(2, 0, 10'000)});
  EXPECT_EQ(result.underruns, 0u);
  EXPECT_NEAR(result.seconds, 0.1 + 1.0 + 0.707 + 0.09, 0.1);
}

TEST(supply, bridges_a_host_that_stutters) {
  PrintRun run(motion_test::mendel(), {.lines_per_second = 150, .refill_seconds = 0.012});
  const RunResult result = run.run(arc(300, 0.3, 100'000));
  EXPECT_EQ(result.underruns, 0u);
  EXPECT_EQ(result.rests, 1u);
}

// Of all sizes and directions, mostly so short that a line lasts less than it takes to hand over.
std::vector<LineMove> short_moves(std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> angle(0, 6.2832), exponent(-3, -0.5);
  std::vector<LineMove> moves;
  double x = 0, y = 0, heading = 0;
  for (int i = 0; i < 1'500; ++i) {
    const double size = std::pow(10, exponent(random));
    heading = seed % 3 == 0 ? angle(random) : heading + (angle(random) - 3.1416) * 0.05;
    x += size * std::cos(heading);
    y += size * std::sin(heading);
    moves.push_back(to(x, y, 20'000 + static_cast<std::int32_t>(random() % 180'000)));
  }
  return moves;
}

class SlowProcessor : public testing::TestWithParam<std::uint32_t> {};

// As slow as at 4 MHz, with the least time of a line that the firmware sets.
TEST_P(SlowProcessor, never_lets_the_queue_run_dry_at_speed) {
  constexpr std::int64_t least_line_clocks = 16'000;
  for (const double lines_per_second : {0.0, 400.0, 120.0}) {
    PrintRun run(motion_test::mendel(),
                 {.clock_hz = 4'000'000,
                  .queue_depth = 32,
                  .lines_per_second = lines_per_second,
                  .processor =
                      motion_test::ProcessorTimes{
                          .append = 14'000, .hand_over = 9'000, .pass = 2'000 + GetParam() * 2'000},
                  .least_line_time = Microseconds(least_line_clocks / 4)});
    const RunResult result = run.run(short_moves(GetParam()));
    EXPECT_EQ(result.underruns, 0u);
    EXPECT_EQ(result.wrong_line_ends, 0u);
  }
}

INSTANTIATE_TEST_SUITE_P(seeds, SlowProcessor, testing::Range(0u, 12u));

}  // namespace
