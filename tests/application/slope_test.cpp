// SPDX-License-Identifier: Apache-2.0
// No change of the scale exceeds an acceleration limit of a line that may still be executed.
#include "application/slope.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <random>

#include "tests/application/dialogue.hpp"

namespace application_test {
namespace {

constexpr std::uint32_t most_lines = 20;

// What the largest slope is that a line allows, in 1/s: along the path, and of each axis.
double slope_of(const motion::Limits& limits, std::int32_t feedrate) {
  double highest = 0;
  double slope = 1e9;
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    const motion::AxisLimits& axis = limits.axes[i];
    const double speed = axis.max_speed.count();
    double acceleration = axis.max_acceleration.count();
    if (i < 3) {
      highest += speed;
    } else {
      acceleration = std::min<double>(acceleration, limits.retract_acceleration.count());
    }
    slope = std::min(slope, acceleration / speed);
  }
  const double least = std::max(limits.min_print_speed, limits.min_travel_speed).count();
  const double path = std::min(highest, std::max<double>(feedrate, least));
  return std::min<double>(
      {slope, limits.print_acceleration.count() / path, limits.travel_acceleration.count() / path});
}

TEST(slope, is_that_of_the_strictest_line_that_may_still_be_executed) {
  std::mt19937 random(5);
  const auto between = [&random](std::int32_t low, std::int32_t high) {
    return low + static_cast<std::int32_t>(random() % static_cast<std::uint32_t>(high - low));
  };
  application::Slope slope(units::Hertz(clock_hz), most_lines);
  motion::Limits limits = machine_under_test().limits;
  slope.set_limits(limits);
  std::deque<double> lines;  // of each, its own slope; the newest in front
  std::uint32_t in_force = 0;
  std::size_t exact = 0;
  for (int i = 0; i < 20'000; ++i) {
    if (random() % 30 == 0) {
      const auto any = [&between] {
        return units::MicrometersPerSecondSquared(between(50'000, 5'000'000));
      };
      limits.print_acceleration = any();
      limits.travel_acceleration = any();
      limits.retract_acceleration = any();
      auto& axis = limits.axes[random() % units::axis_count];
      axis.max_acceleration = any();
      axis.max_speed = units::MicrometersPerSecond(between(1000, 500'000));
      limits.min_print_speed = units::MicrometersPerSecond(between(0, 3) * 20'000);
      slope.set_limits(limits);
    }
    if (random() % 400 == 0) {
      slope.note_rest();
      lines.clear();
    }
    const std::int32_t feedrate = between(100, 400'000);
    lines.push_front(slope_of(limits, feedrate));
    if (const auto changed = slope.note_line(units::MicrometersPerSecond(feedrate))) {
      in_force = *changed;
    }
    const double per_second = std::ldexp(in_force, -32) * clock_hz;
    const auto strictest = [&lines](std::size_t count) {
      return *std::min_element(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(
                                                                  std::min(lines.size(), count)));
    };
    const double resolution = std::ldexp(clock_hz, -32);
    ASSERT_LE(per_second, strictest(most_lines) * 1.0001) << i;
    // The least acceleration may be that of another line than the highest speed.
    if (per_second >= strictest(2 * most_lines) * 0.9999 - 2 * resolution) ++exact;
  }
  EXPECT_GT(exact, 8000u);
}

TEST(slope, is_as_steep_as_the_feedrate_of_the_lines_permits) {
  application::Slope slope(units::Hertz(clock_hz), most_lines);
  motion::Limits limits = machine_under_test().limits;
  slope.set_limits(limits);
  // M204 1500 mm/s^2 at 120 mm/s is 12.5 per second; X and Y alone bear 3000 / 200, E 1500 / 80.
  const auto per_second = [](std::optional<std::uint32_t> value) {
    return std::ldexp(value.value_or(0), -32) * clock_hz;
  };
  EXPECT_NEAR(per_second(slope.note_line(units::MicrometersPerSecond(120'000))), 12.5, 0.01);
  EXPECT_FALSE(slope.note_line(units::MicrometersPerSecond(60'000)).has_value());
  slope.note_rest();
  EXPECT_NEAR(per_second(slope.note_line(units::MicrometersPerSecond(60'000))), 15, 0.01);
}

}  // namespace
}  // namespace application_test
