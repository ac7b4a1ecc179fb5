// SPDX-License-Identifier: Apache-2.0
// An axis follows its steps within the motor's limits, and loses steps beyond.
#include "sim/plants/axis.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace {

// The X axis of the default machine: 80 steps/mm, 3000 mm/s^2 with eightfold reserve, 400 mm/s.
constexpr plants::AxisProperties x_axis{.steps_per_mm = 80,
                                        .torque_acceleration = 8 * 3000 * 80.0,
                                        .speed_limit = 2 * 200 * 80.0,
                                        .lower_frame = -160,
                                        .upper_frame = 16'400};

// Steps along a ramp from standstill: constant acceleration up to a speed, in steps and seconds.
double ramp(plants::Axis& axis, double start, int steps, double acceleration, double speed,
            int direction = 1) {
  double seconds = start, rate = 0;
  for (int i = 0; i < steps; ++i) {
    const double next = std::min(speed, std::sqrt(rate * rate + 2 * acceleration));
    seconds += 2 / (rate + next);
    rate = next;
    axis.step(seconds, direction);
  }
  return seconds;
}

TEST(Axis, follows_every_step_of_a_ramp_at_the_limits_of_the_machine) {
  plants::Axis axis(x_axis, 100);
  ramp(axis, 1.0, 8000, 3000 * 80.0, 200 * 80.0);
  EXPECT_EQ(axis.position(), 8100);
  EXPECT_EQ(axis.slipped_steps(), 0U);
  EXPECT_LT(axis.peak_load(), 0.7);
}

TEST(Axis, starts_at_the_permitted_jerk_without_loss) {
  plants::Axis axis(x_axis, 0);
  const double interval = 1.0 / (10 * 80.0);
  for (int i = 1; i <= 1000; ++i) axis.step(1.0 + i * interval, 1);
  EXPECT_EQ(axis.position(), 1000);
  EXPECT_EQ(axis.slipped_steps(), 0U);
}

TEST(Axis, loses_steps_where_it_is_started_at_full_speed) {
  plants::Axis axis(x_axis, 0);
  const double interval = 1.0 / (200 * 80.0);
  for (int i = 1; i <= 2000; ++i) axis.step(1.0 + i * interval, 1);
  EXPECT_GT(axis.slipped_steps(), 500U);
  EXPECT_LT(axis.position(), 1500);
}

TEST(Axis, loses_steps_beyond_its_speed_limit_however_slowly_it_is_accelerated) {
  plants::Axis axis(x_axis, 0);
  ramp(axis, 1.0, 16'000, 1000 * 80.0, 1000 * 80.0);
  EXPECT_GT(axis.slipped_steps(), 0U);
}

TEST(Axis, loses_whole_electrical_periods_only) {
  plants::Axis axis(x_axis, 0);
  const double interval = 1.0 / (200 * 80.0);
  for (int i = 1; i <= 2000; ++i) axis.step(1.0 + i * interval, 1);
  EXPECT_EQ(axis.slipped_steps() % 64, 0U);
  EXPECT_EQ((2000 - axis.position()) % 64, 0);
}

TEST(Axis, stops_at_its_frame_and_counts_the_steps_lost_there) {
  plants::Axis axis(x_axis, 0);
  for (int i = 1; i <= 200; ++i) axis.step(1.0 + 0.01 * i, -1);
  EXPECT_EQ(axis.position(), -160);
  EXPECT_EQ(axis.frame_steps(), 40U);
  EXPECT_EQ(axis.slipped_steps(), 0U);
}

TEST(Axis, has_no_memory_of_motion_after_a_long_rest) {
  plants::Axis axis(x_axis, 0), rested(x_axis, 0);
  const double end = ramp(axis, 1.0, 500, 3000 * 80.0, 8000);
  axis.step(end + 5, 1);
  rested.step(5, 1);
  EXPECT_EQ(axis.position(), 501);
  EXPECT_EQ(axis.slipped_steps(), 0U);
}

}  // namespace
