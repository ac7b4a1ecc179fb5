// SPDX-License-Identifier: Apache-2.0
// The intervals between ticks against the closed form of the ramp.
#include "software_stepping/interval.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

using software_stepping::advance_short_interval;
using software_stepping::first_interval;
using software_stepping::Interval;
using software_stepping::next_interval;
using software_stepping::Ramp;

constexpr Interval longest = Interval{5'000'000} << 16;

long double clocks_of(Interval interval) { return static_cast<long double>(interval) / 65536; }

std::int64_t acceleration_of(long double per_clock_squared) {
  return static_cast<std::int64_t>(std::ldexp(per_clock_squared, 84));
}

std::uint64_t rate_of(long double per_clock) {
  return static_cast<std::uint64_t>(std::ldexp(per_clock, 64));
}

// The time to the first tick.
long double root_of(long double rate, long double acceleration) {
  return 2 / (rate + std::sqrt(rate * rate + 2 * acceleration));
}

TEST(interval, of_a_constant_rate_is_its_inverse) {
  for (const std::uint64_t clocks : {2u, 3u, 7u, 100u, 5000u, 65535u, 65536u, 4'999'999u}) {
    const std::uint64_t rate = ~std::uint64_t{0} / clocks;
    const Interval interval = first_interval(rate, 0, longest);
    EXPECT_NEAR(static_cast<double>(interval), static_cast<double>(clocks << 16),
                1 + static_cast<double>(clocks) * 0x1p-14)
        << clocks;
  }
  EXPECT_EQ(first_interval(rate_of(0.0002L), 0, longest), Interval{5000} << 16);
}

TEST(interval, to_the_first_tick_of_a_ramp_is_the_root_of_its_course) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> size(-34, -22), entry(-1, 12);
  for (int i = 0; i < 20'000; ++i) {
    const long double acceleration = std::exp2(static_cast<long double>(size(random)));
    const long double rate =
        std::sqrt(acceleration) * std::exp2(static_cast<long double>(entry(random)) / 2);
    const Interval up = first_interval(rate_of(rate), acceleration_of(acceleration), longest);
    EXPECT_NEAR(static_cast<double>(clocks_of(up) / root_of(rate, acceleration)), 1, 3e-5);
    if (rate * rate < 3 * acceleration) continue;
    const Interval down = first_interval(rate_of(rate), acceleration_of(-acceleration), longest);
    EXPECT_NEAR(static_cast<double>(clocks_of(down) / root_of(rate, -acceleration)), 1, 3e-5);
  }
}

TEST(interval, from_rest_needs_no_rate) {
  const long double acceleration = 1e-9L;
  const Interval interval = first_interval(0, acceleration_of(acceleration), longest);
  EXPECT_NEAR(static_cast<double>(clocks_of(interval)), std::sqrt(2e9), 1);
  EXPECT_EQ(first_interval(0, 0, longest), longest);
}

TEST(interval, is_the_longest_where_the_rate_would_fall_to_nothing) {
  EXPECT_EQ(first_interval(rate_of(1e-5L), acceleration_of(-1e-9L), longest), longest);
  const Ramp ramp = Ramp::of(acceleration_of(-1e-9L));
  EXPECT_EQ(next_interval(Interval{100'000} << 16, ramp, longest), longest);
}

// Follows a ramp from rest with what the interrupt uses: the short way where it goes.
struct Course {
  long double time = 0;
  Interval interval{};
};
Course follow(long double acceleration, int ticks) {
  const Ramp ramp = Ramp::of(acceleration_of(acceleration));
  Course course{.interval = first_interval(rate_of(std::sqrt(acceleration)),
                                           acceleration_of(acceleration), longest)};
  for (int tick = 1;; ++tick) {
    course.time += clocks_of(course.interval);
    if (tick == ticks) return course;
    auto word = static_cast<std::uint32_t>(course.interval);
    const bool is_short = course.interval < 1u << 29;
    if (is_short && advance_short_interval(word, ramp.mantissa, ramp.shift)) {
      course.interval = word;
    } else {
      course.interval = next_interval(course.interval, ramp, longest);
    }
  }
}

// With the entry rate sqrt(a) of a line from rest, tick n comes at (sqrt(1 + 2 n) - 1) / sqrt(a).
TEST(interval, follows_a_whole_ramp) {
  struct Machine {
    double clock_hz, steps_per_second_squared;
    int ticks;
  };
  for (const Machine& machine :
       {Machine{50e6, 240e3, 600}, Machine{50e6, 5e6, 1600}, Machine{8e6, 240e3, 600},
        Machine{8e6, 5e6, 160}, Machine{100e6, 1e6, 3000}, Machine{50e6, 1e8, 3000}}) {
    const long double acceleration =
        machine.steps_per_second_squared /
        (static_cast<long double>(machine.clock_hz) * machine.clock_hz);
    for (const int ticks : {1, 2, 5, 20, 100, machine.ticks}) {
      const long double exact = (std::sqrt(1 + 2.0L * ticks) - 1) / std::sqrt(acceleration);
      const long double before = (std::sqrt(2.0L * ticks - 1) - 1) / std::sqrt(acceleration);
      const Course course = follow(acceleration, ticks);
      EXPECT_NEAR(static_cast<double>(course.time / exact), 1, 5e-4)
          << machine.clock_hz << " Hz, " << machine.steps_per_second_squared << ", tick " << ticks;
      EXPECT_NEAR(static_cast<double>(clocks_of(course.interval) / (exact - before)), 1, 2e-3)
          << machine.clock_hz << " Hz, " << machine.steps_per_second_squared << ", tick " << ticks;
    }
  }
}

TEST(interval, keeps_away_from_what_the_short_way_cannot) {
  std::uint32_t interval = 1u << 28;
  const Ramp steep = Ramp::of(acceleration_of(0.2L / (4096.0L * 4096.0L)));
  EXPECT_FALSE(advance_short_interval(interval, steep.mantissa, steep.shift));
  EXPECT_EQ(interval, 1u << 28);
  interval = (1u << 29) - 1;
  const Ramp braking = Ramp::of(acceleration_of(-0.05L / (8192.0L * 8192.0L)));
  EXPECT_FALSE(advance_short_interval(interval, braking.mantissa, braking.shift));
  EXPECT_EQ(interval, (1u << 29) - 1);
}

}  // namespace
