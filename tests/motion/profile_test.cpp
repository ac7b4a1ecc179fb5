// SPDX-License-Identifier: Apache-2.0
// Phases of random lines: whole ticks, matching rates, the acceleration kept, at any clock.
#include "motion/profile.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "tests/motion/machine.hpp"

namespace {

using motion::Line;
using motion::Phase;
using motion::Profile;
using motion::SpecificEnergy;
using units::MicrometersPerSecond;

// Ticks per clock, and per clock^2, without the half acceleration that the start rate contains.
double acceleration_of(const Phase& phase) {
  return static_cast<double>(phase.acceleration) * 0x1p-84;
}
double start_rate(const Phase& phase) {
  return static_cast<double>(phase.rate) * 0x1p-64 - acceleration_of(phase) / 2;
}
double end_rate(const Phase& phase) {
  const double start = start_rate(phase);
  return std::sqrt(start * start + 2 * acceleration_of(phase) * phase.ticks);
}

Line x_line(std::int32_t steps, std::int32_t um_s, std::uint32_t clock_hz) {
  const motion::Geometry geometry(motion_test::mendel(), motion_test::timing(clock_hz));
  const motion::Displacement displacement{.distance = {units::Nanometers(steps * 12'500)},
                                          .steps = {steps, 0, 0, 0}};
  Line line;
  geometry.make_line(displacement, MicrometersPerSecond(um_s), {}, line);
  return line;
}

SpecificEnergy random_energy(std::mt19937_64& random, SpecificEnergy low, SpecificEnergy high) {
  return low + SpecificEnergy(random() % ((high - low).count() + 1));
}

TEST(profile, keeps_ticks_rates_and_acceleration_of_random_lines) {
  std::mt19937_64 random(4);
  double worst_mismatch = 0;
  for (int i = 0; i < 50'000; ++i) {
    const auto clock_hz = static_cast<std::uint32_t>(4'000'000 + random() % 96'000'000);
    const auto steps = static_cast<std::int32_t>(1 + (random() >> (50 + random() % 14)));
    Line line = x_line(steps, static_cast<std::int32_t>(1 + random() % 200'000), clock_hz);
    line.entry = random_energy(random, {}, line.nominal());
    const SpecificEnergy highest = std::min(line.nominal(), line.entry + line.work);
    const SpecificEnergy lowest =
        line.entry > line.work ? line.entry - line.work : SpecificEnergy();
    const SpecificEnergy exit = random_energy(random, lowest, highest);
    const Profile profile = motion::profile_of(line, exit, units::Hertz(clock_hz));

    const double clock = clock_hz;
    const double ticks_per_s2 = 1'500 * 80;  // of 1500 mm/s^2 on X
    const double nominal = std::sqrt(2e-3 * static_cast<double>(line.nominal().count())) * 80e-3;
    const double floor = std::min(std::sqrt(ticks_per_s2), nominal);
    const auto expected = [&](SpecificEnergy energy) {
      const double rate = std::sqrt(2e-3 * static_cast<double>(energy.count())) * 80e-3;
      return std::max(rate, floor) / clock;
    };
    ASSERT_GE(profile.count, 1u);
    std::uint64_t ticks = 0;
    double rate = expected(line.entry);
    double seconds = 0;
    for (std::size_t p = 0; p < profile.count; ++p) {
      const Phase& phase = profile.phases[p];
      ticks += phase.ticks;
      ASSERT_GE(phase.ticks, 1u);
      ASSERT_NEAR(start_rate(phase) / rate, 1, 1e-6) << "phase " << p << " of line " << i;
      worst_mismatch = std::max(worst_mismatch, std::abs(start_rate(phase) / rate - 1));
      ASSERT_LE(std::abs(acceleration_of(phase)) * clock * clock, ticks_per_s2 * (1 + 1e-6))
          << "phase " << p << " of line " << i;
      ASSERT_LE(start_rate(phase) * clock, nominal * (1 + 1e-6));
      rate = end_rate(phase);
      seconds += 2 * phase.ticks / (start_rate(phase) + rate) / clock;
    }
    ASSERT_EQ(ticks, line.ticks());
    ASSERT_NEAR(rate / expected(exit), 1, 1e-5) << "end of line " << i;
    ASSERT_NEAR(static_cast<double>(profile.time.count()) * 1e-6, seconds, 4e-6 + seconds * 1e-6);
  }
  std::printf("worst mismatch of rates %.2e\n", worst_mismatch);
}

TEST(profile, of_one_tick_has_one_phase) {
  for (const std::uint32_t clock_hz : {4'000'000u, 100'000'000u}) {
    Line line = x_line(1, 200'000, clock_hz);
    const Profile profile = motion::profile_of(line, {}, units::Hertz(clock_hz));
    EXPECT_EQ(profile.count, 1u);
    EXPECT_EQ(profile.phases[0].ticks, 1u);
    EXPECT_GT(profile.phases[0].rate, 0u);
    EXPECT_EQ(profile.phases[0].acceleration, 0);
  }
}

TEST(profile, of_a_long_line_accelerates_cruises_and_brakes) {
  const Line line = x_line(8'000, 100'000, 50'000'000);
  const Profile profile = motion::profile_of(line, {}, units::Hertz(50'000'000));
  ASSERT_EQ(profile.count, 3u);
  EXPECT_GT(profile.phases[0].acceleration, 0);
  EXPECT_EQ(profile.phases[1].acceleration, 0);
  EXPECT_LT(profile.phases[2].acceleration, 0);
  EXPECT_NEAR(start_rate(profile.phases[1]) * 50e6, 8'000, 0.01);
  EXPECT_NEAR(profile.phases[0].ticks, 8'000.0 * 8'000 / 2 / 120'000, 2);
}

TEST(profile, of_a_slow_line_never_exceeds_its_nominal_rate) {
  const Line line = x_line(8, 17, 4'000'000);  // F1: 1.36 steps/s
  const Profile profile = motion::profile_of(line, {}, units::Hertz(4'000'000));
  ASSERT_EQ(profile.count, 1u);
  EXPECT_NEAR(start_rate(profile.phases[0]) * 4e6, 1.36, 0.001);
}

// The hardware's format holds 2^-21 ticks per clock^2; the axis below would exceed it at 4 MHz.
TEST(profile, of_a_violent_axis_at_a_slow_clock_is_limited_by_the_format) {
  motion::Limits limits = motion_test::mendel();
  limits.of(units::Axis::z).max_acceleration = motion::max_acceleration;
  limits.of(units::Axis::z).max_speed = MicrometersPerSecond(1'000'000);
  limits.travel_acceleration = motion::max_acceleration;
  motion::StepTiming timing = motion_test::timing(4'000'000);
  timing.max_step_rate.fill(units::Hertz(10'000'000));
  const motion::Geometry geometry(limits, timing);
  const motion::Displacement displacement{
      .distance = {units::Nanometers(), units::Nanometers(), units::Nanometers(1'000'000'000)},
      .steps = {0, 0, 2'560'000, 0}};
  Line line;
  geometry.make_line(displacement, MicrometersPerSecond(900'000), {}, line);
  const Profile profile = motion::profile_of(line, {}, units::Hertz(4'000'000));
  ASSERT_EQ(profile.count, 3u);
  for (const Phase& phase : profile.phases) {
    EXPECT_LE(phase.rate, std::uint64_t{1} << 63);
    EXPECT_LE(std::abs(acceleration_of(phase)), 0x1p-21);
  }
  EXPECT_NEAR(end_rate(profile.phases[0]) / start_rate(profile.phases[1]), 1, 1e-6);
  EXPECT_NEAR(start_rate(profile.phases[1]), 0.5, 1e-6);
}

}  // namespace
