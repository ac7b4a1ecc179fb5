// SPDX-License-Identifier: Apache-2.0
// The firmware's thermal logic holds the simulated hotend and bed, measured as coarsely as the
// clock allows.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/thermal/closed_loop.hpp"

namespace {

using tests::bed_settings;
using tests::Bench;
using tests::Course;
using tests::hotend_settings;

constexpr double fan_mean = 0.6;

class ClosedLoop : public testing::TestWithParam<double> {};

TEST_P(ClosedLoop, hotend_overshoots_less_than_five_degrees_and_stays_within_two_while_printing) {
  for (const double target : {185.0, 205.0, 250.0}) {
    Bench bench(tests::described_hotend(), hotend_settings(), GetParam(), 1);
    const Course course = bench.run(target, 400, [&bench](double printing) {
      if (printing < 0) return;
      // After 30 s the fan comes on, later it goes up and down; filament comes in fits and starts.
      const double now = bench.now();
      const double second = std::floor(printing);
      bench.block.set_fan(now, second < 30                  ? 0
                               : second < 120               ? fan_mean
                               : std::fmod(second, 40) < 20 ? 1
                                                            : 0.3);
      bench.block.set_extrusion(now, std::fmod(second, 7) < 5 ? 4.0 : 0.0);
    });
    EXPECT_EQ(course.fault, std::nullopt);
    EXPECT_GT(course.arrived, 0);
    EXPECT_LT(course.arrived, 200);
    EXPECT_LT(course.highest, target + 5);
    EXPECT_LT(course.band, 2.0) << target;
    RecordProperty("band_at_" + std::to_string(static_cast<int>(target)),
                   std::to_string(course.band));
  }
}

TEST_P(ClosedLoop, bed_stays_within_one_degree) {
  for (const double target : {60.0, 100.0}) {
    Bench bench(tests::described_bed(), bed_settings(), GetParam(), 2);
    const Course course = bench.run(target, 1'500, [](double) {});
    EXPECT_EQ(course.fault, std::nullopt);
    EXPECT_GT(course.arrived, 0);
    EXPECT_LT(course.highest, target + 2);
    EXPECT_LT(course.band, 1.0);
  }
}

TEST_P(ClosedLoop, follows_a_change_of_the_target_in_both_directions) {
  Bench bench(tests::described_hotend(), hotend_settings(), GetParam(), 3);
  EXPECT_LT(bench.run(205, 200, [](double) {}).band, 2.0);
  EXPECT_LT(bench.run(190, 200, [](double) {}).band, 2.0);
  const Course up = bench.run(220, 200, [](double) {});
  EXPECT_LT(up.highest, 225);
  EXPECT_LT(up.band, 2.0);
}

INSTANTIATE_TEST_SUITE_P(at, ClosedLoop, testing::Values(4e6, 8e6, 50e6), [](const auto& clock) {
  return std::to_string(static_cast<int>(clock.param / 1e6)) + "_mhz";
});

TEST(closed_loop, finds_a_heater_that_fails_while_printing) {
  Bench bench(tests::described_hotend(), hotend_settings(), 8e6, 4);
  const Course course = bench.run(205, 500, [&bench](double printing) {
    if (printing > 20) bench.block.set_fault(bench.now(), plants::HeaterFault::stuck_off);
  });
  EXPECT_EQ(course.fault, thermal::Fault::thermal_runaway);
}

TEST(closed_loop, finds_a_heater_that_sticks_before_it_is_dangerous) {
  Bench bench(tests::described_hotend(), hotend_settings(), 8e6, 5);
  const Course course = bench.run(205, 500, [&bench](double printing) {
    if (printing > 20) bench.block.set_fault(bench.now(), plants::HeaterFault::stuck_on);
  });
  EXPECT_EQ(course.fault, thermal::Fault::unasked_heat);
  EXPECT_LT(course.highest, 260);
}

}  // namespace
