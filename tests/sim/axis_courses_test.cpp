// SPDX-License-Identifier: Apache-2.0
// Speeds and accelerations from edges of which the true course is known.
#include "sim/report/axis_courses.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace {

constexpr sim::ClockRate rate(4'000'000);
constexpr double steps_per_mm = 80;
constexpr double h = report::AxisCourses::half_window_seconds;
// Worst of an axis whose edges are late by up to one tick: 2 steps / h^2.
constexpr double noise_mm_s2 = 2 / steps_per_mm / (h * h);
// Where an axis stops half a step after its last edge.
constexpr double half_step_mm_s2 = noise_mm_s2 / 4;

class AxisCoursesTest : public testing::Test {
 protected:
  // Edges of an axis that follows position_mm(t), each where it passes half-way between two steps;
  // with `tick_clocks`, late until the next tick.
  void follow(std::size_t axis, double seconds, const std::function<double(double)>& position_mm,
              sim::Clock tick_clocks = 1) {
    std::int64_t steps = std::llround(position_mm(0) * steps_per_mm);
    for (sim::Clock now = 0; now < rate.clocks(seconds); now += tick_clocks) {
      const double wanted = position_mm(rate.seconds(now)) * steps_per_mm;
      const int direction = wanted > static_cast<double>(steps) ? 1 : -1;
      if (std::abs(wanted - static_cast<double>(steps)) >= 0.5) {
        steps += direction;
        courses.stepped({now, axis, direction, steps});
      }
    }
    ended = rate.clocks(seconds);
  }
  report::AxisCourse course(std::size_t axis) const { return courses.courses(ended)[axis]; }

  static report::Range extremes(const report::RangeCourse& course, double from, double to) {
    report::Range all{1e9F, -1e9F};
    for (std::size_t i = 0; i < course.buckets().size(); ++i) {
      const double t = (static_cast<double>(i) + 0.5) * course.bucket_seconds();
      if (t >= from && t < to) {
        all.low = std::min(all.low, course.buckets()[i].low);
        all.high = std::max(all.high, course.buckets()[i].high);
      }
    }
    return all;
  }

  report::AxisCourses courses{rate, {steps_per_mm, steps_per_mm, 2560, 500}, {0, 0, 0, 0}};
  sim::Clock ended = 0;
};

TEST_F(AxisCoursesTest, finds_speed_and_acceleration_of_a_ramp) {
  // From rest with 1500 mm/s^2 to 60 mm/s, even, and back to rest.
  follow(0, 0.4, [](double t) {
    constexpr double a = 1500, top = 60, ramp = top / a, end = 0.3;
    if (t < ramp) return a * t * t / 2;
    const double even = top * ramp / 2 + top * (std::min(t, end) - ramp);
    if (t < end) return even;
    const double braking = std::min(t - end, ramp);
    return even + top * braking - a * braking * braking / 2;
  });
  const report::AxisCourse found = course(0);
  const report::Range even = extremes(found.speed_mm_s, 0.06, 0.28);
  EXPECT_NEAR(even.low, 60, 0.05);
  EXPECT_NEAR(even.high, 60, 0.05);
  EXPECT_NEAR(extremes(found.acceleration_mm_s2, 0, 0.06).high, 1500, half_step_mm_s2);
  EXPECT_NEAR(extremes(found.acceleration_mm_s2, 0.28, 0.4).low, -1500, half_step_mm_s2);
  const report::Range between = extremes(found.acceleration_mm_s2, 0.06, 0.28);
  EXPECT_LT(std::max(between.high, -between.low), 5);
  EXPECT_NEAR(extremes(found.position_mm, 0, 0.5).high, 60 * 0.3, 0.02);
}

TEST_F(AxisCoursesTest, shows_an_acceleration_above_the_limit) {
  follow(0, 0.06, [](double t) { return 4500 * t * t / 2; });
  EXPECT_GT(extremes(course(0).acceleration_mm_s2, 0.01, 0.05).high, 4400);
}

TEST_F(AxisCoursesTest, shows_a_jump_of_speed_as_the_jump_by_the_half_window) {
  follow(0, 0.2, [](double t) { return t < 0.1 ? 0.0 : 20 * (t - 0.1); });
  EXPECT_NEAR(extremes(course(0).acceleration_mm_s2, 0, 0.2).high, 20 / h, noise_mm_s2 / 2);
}

TEST_F(AxisCoursesTest, takes_a_reversal_for_no_step) {
  // Braked evenly from 60 mm/s until it goes back as fast. Up to half a step of the way there and
  // back has no edge; the middle of the window counts twice.
  follow(0, 0.08, [](double t) { return 60 * t - 1500 * t * t / 2; });
  const report::Range found = extremes(course(0).acceleration_mm_s2, 0.012, 0.068);
  EXPECT_NEAR(found.low, -1500, 2 * half_step_mm_s2);
  EXPECT_NEAR(found.high, -1500, 2 * half_step_mm_s2);
}

TEST_F(AxisCoursesTest, keeps_the_noise_of_late_edges_below_what_the_page_says) {
  // 31 mm/s on an axis whose edges wait for ticks at 60 mm/s.
  const sim::Clock tick = rate.clocks(1 / (60 * steps_per_mm));
  follow(1, 2.0, [](double t) { return 31 * t; }, tick);
  const report::AxisCourse found = course(1);
  const report::Range noise = extremes(found.acceleration_mm_s2, 0.1, 1.9);
  EXPECT_GT(noise.high, 10);  // there is some
  EXPECT_LT(std::max(noise.high, -noise.low), noise_mm_s2);
  const report::Range speed = extremes(found.speed_mm_s, 0.1, 1.9);
  EXPECT_NEAR(speed.low, 31, 1 / steps_per_mm / h);
  EXPECT_NEAR(speed.high, 31, 1 / steps_per_mm / h);
}

TEST_F(AxisCoursesTest, lasts_as_long_as_the_print) {
  follow(0, 0.1, [](double t) { return 10 * t; });
  ended = rate.clocks(3);
  const report::AxisCourse found = course(0);
  for (const report::RangeCourse* one :
       {&found.position_mm, &found.speed_mm_s, &found.acceleration_mm_s2}) {
    EXPECT_NEAR(static_cast<double>(one->buckets().size()) * one->bucket_seconds(), 3, 0.03);
  }
  EXPECT_EQ(extremes(found.speed_mm_s, 0.2, 3).high, 0);
}

TEST(RangeCourse, loses_no_peak_however_long_it_gets) {
  report::RangeCourse course(0.001);
  constexpr std::size_t samples = 10 * report::RangeCourse::most_buckets + 5;
  for (std::size_t i = 0; i < samples; ++i) course.put(i == 12'345 ? 100 : i == 54'321 ? -100 : 1);
  EXPECT_LE(course.buckets().size(), report::RangeCourse::most_buckets);
  EXPECT_NEAR(static_cast<double>(course.buckets().size()) * course.bucket_seconds(),
              0.001 * samples, course.bucket_seconds());
  const auto at = [&](std::size_t sample) {
    return course.buckets()[static_cast<std::size_t>(static_cast<double>(sample) * 0.001 /
                                                     course.bucket_seconds())];
  };
  EXPECT_EQ(at(12'345).high, 100);
  EXPECT_EQ(at(12'345).low, 1);
  EXPECT_EQ(at(54'321).low, -100);
}

}  // namespace
