// SPDX-License-Identifier: Apache-2.0
// Positions in steps, limits and bounds.
#include "motion/limits.hpp"

#include <gmock/gmock.h>

#include <random>

#include "motion/steps.hpp"
#include "tests/motion/machine.hpp"
#include "tests/motion/print_run.hpp"

namespace {

using motion::Fault;
using motion_test::at;
using motion_test::mendel;
using units::Axis;
using units::MicrometersPerSecond;
using units::MicrometersPerSecondSquared;
using units::Nanometers;
using units::StepsPerMeter;

TEST(steps, round_halves_away_from_zero) {
  const StepsPerMeter eighty(80'000);
  EXPECT_EQ(motion::steps_at(Nanometers(6'249), eighty).steps, 0);
  EXPECT_EQ(motion::steps_at(Nanometers(6'250), eighty).steps, 1);
  EXPECT_EQ(motion::steps_at(Nanometers(-6'249), eighty).steps, 0);
  EXPECT_EQ(motion::steps_at(Nanometers(-6'250), eighty).steps, -1);
  EXPECT_EQ(motion::steps_at(Nanometers(1'000'000), StepsPerMeter(62'745)).steps, 63);
}

TEST(steps, are_exact_for_any_position) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 300'000; ++i) {
    const auto size = static_cast<std::int64_t>(random() >> (14 + random() % 49));
    const Nanometers position(std::min(size, motion::max_position.count()) * (i % 2 == 0 ? 1 : -1));
    const StepsPerMeter factor(static_cast<std::int32_t>(1 + random() % 10'000'000));
    ASSERT_EQ(motion::steps_at(position, factor).steps, motion_test::exact_steps(position, factor))
        << position.count() << " nm at " << factor.count();
  }
}

TEST(steps, leave_a_residual_to_the_position) {
  const StepsPerMeter eighty(80'000);
  const std::int32_t step = motion::one_step.count();
  EXPECT_EQ(motion::steps_at(Nanometers(12'500), eighty).residual.count(), 0);
  EXPECT_EQ(motion::steps_at(Nanometers(-12'500), eighty).residual.count(), 0);
  EXPECT_NEAR(motion::steps_at(Nanometers(15'625), eighty).residual.count(), step / 4, 1);
  EXPECT_NEAR(motion::steps_at(Nanometers(-15'625), eighty).residual.count(), -step / 4, 1);
  EXPECT_NEAR(motion::steps_at(Nanometers(6'250), eighty).residual.count(), -step / 2, 1);
  EXPECT_NEAR(motion::steps_at(Nanometers(-6'250), eighty).residual.count(), step / 2, 1);
}

TEST(steps, and_residual_make_the_position) {
  std::mt19937_64 random(4);
  for (int i = 0; i < 100'000; ++i) {
    const auto size = static_cast<std::int64_t>(random() >> (14 + random() % 49));
    const Nanometers position(std::min(size, motion::max_position.count()) * (i % 2 == 0 ? 1 : -1));
    const StepsPerMeter factor(static_cast<std::int32_t>(1 + random() % 10'000'000));
    const motion::StepPosition result = motion::steps_at(position, factor);
    const auto exact = static_cast<motion_test::Wide>(position.count()) * factor.count();
    const auto rest = exact - static_cast<motion_test::Wide>(result.steps) * 1'000'000'000;
    ASSERT_NEAR(result.residual.count(), static_cast<double>(rest) / 512, 1)
        << position.count() << " nm at " << factor.count();
  }
}

TEST(steps, come_back_from_their_position) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 100'000; ++i) {
    const auto steps = static_cast<std::int64_t>(random() % 2'000'000'000'000) - 1'000'000'000'000;
    const StepsPerMeter factor(static_cast<std::int32_t>(1'000 + random() % 5'000'000));
    ASSERT_EQ(motion::steps_at(motion::position_of(steps, factor), factor).steps, steps);
  }
}

TEST(limits, take_values_in_range_and_refuse_others_unchanged) {
  motion::Limits limits = mendel();
  EXPECT_TRUE(motion::set_max_speed(limits, Axis::z, MicrometersPerSecond(5'000)));
  EXPECT_EQ(limits.of(Axis::z).max_speed, MicrometersPerSecond(5'000));
  const auto zero_speed = motion::set_max_speed(limits, Axis::z, MicrometersPerSecond(0));
  EXPECT_EQ(zero_speed.error(), Fault::speed_out_of_range);
  EXPECT_EQ(limits.of(Axis::z).max_speed, MicrometersPerSecond(5'000));

  const auto negative =
      motion::set_max_acceleration(limits, Axis::x, MicrometersPerSecondSquared(-1));
  EXPECT_EQ(negative.error(), Fault::acceleration_out_of_range);
  EXPECT_EQ(limits.of(Axis::x).max_acceleration, mendel().of(Axis::x).max_acceleration);

  EXPECT_TRUE(motion::set_jerk(limits, Axis::e, MicrometersPerSecond(0)));
  EXPECT_EQ(motion::set_jerk(limits, Axis::e, MicrometersPerSecond(-1)).error(),
            Fault::jerk_out_of_range);
  EXPECT_EQ(motion::set_steps_per_meter(limits, Axis::x, StepsPerMeter(0)).error(),
            Fault::steps_per_meter_out_of_range);
  EXPECT_TRUE(motion::set_steps_per_meter(limits, Axis::x, StepsPerMeter(62'745)));
  EXPECT_EQ(motion::set_print_acceleration(limits, MicrometersPerSecondSquared(0)).error(),
            Fault::acceleration_out_of_range);
  EXPECT_EQ(motion::set_travel_acceleration(limits, motion::max_acceleration * 2).error(),
            Fault::acceleration_out_of_range);
  EXPECT_TRUE(motion::set_retract_acceleration(limits, MicrometersPerSecondSquared(1'000)));
  EXPECT_TRUE(motion::set_min_print_speed(limits, MicrometersPerSecond(0)));
  EXPECT_EQ(motion::set_min_travel_speed(limits, motion::max_speed * 2).error(),
            Fault::speed_out_of_range);
}

TEST(limits, bound_the_axes_that_are_homed) {
  const motion::Limits limits = mendel();
  units::AxisSet homed;
  const auto outside = at(-1, 200'000'001, 50'000'000, 900'000'000);
  EXPECT_EQ(motion::check_bounds(limits, homed, outside), std::nullopt);
  homed.insert(Axis::y);
  EXPECT_EQ(motion::check_bounds(limits, homed, outside), Axis::y);
  EXPECT_EQ(motion::check_bounds(limits, units::AxisSet::all(), outside), Axis::x);
  const auto corner = at(0, 200'000'000, 110'000'000, -900'000'000);
  EXPECT_EQ(motion::check_bounds(limits, units::AxisSet::all(), corner), std::nullopt);
}

TEST(faults, have_a_text_each) {
  for (int i = 0; i <= static_cast<int>(Fault::end_stop_stuck); ++i) {
    EXPECT_NE(motion::describe(static_cast<Fault>(i)), "unknown motion fault");
  }
}

}  // namespace
