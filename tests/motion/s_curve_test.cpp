// SPDX-License-Identifier: Apache-2.0
// Ramps of third order against the exact cubic in floating point, found independently: two
// parabolas of the rate that make the ticks of both segments, from one rate to the other.
#include "motion/s_curve.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <random>
#include <vector>

namespace {

using motion::SCurve;
using motion::Segment;

using Real = long double;

// rate(t) = rate + acceleration t + jerk t^2 / 2, in ticks and clocks.
struct Course {
  Real rate{}, acceleration{}, jerk{};

  Real ticks(Real t) const { return ((jerk / 6 * t + acceleration / 2) * t + rate) * t; }
  Real rate_at(Real t) const { return (jerk / 2 * t + acceleration) * t + rate; }
  Real acceleration_at(Real t) const { return acceleration + jerk * t; }
  // When so many ticks are made. Not far beyond that the rate may fall below 0.
  Real time_of(Real made) const {
    Real low = 0, high = 1;
    while (ticks(high) < made && high < 1e18L) low = high, high *= 1.2L;
    for (int i = 0; i < 80; ++i) (ticks((low + high) / 2) < made ? low : high) = (low + high) / 2;
    return high;
  }
};

// What the hardware does with a segment, without its order of additions.
Course course_of(const Segment& segment) {
  const Real jerk = std::ldexp(static_cast<Real>(segment.jerk), -84);
  const Real acceleration = std::ldexp(static_cast<Real>(segment.acceleration), -84) - jerk;
  const Real rate = std::ldexp(static_cast<Real>(segment.rate), -64) - acceleration / 2 - jerk / 6;
  return {rate, acceleration, jerk};
}

struct Ramp {
  std::uint32_t ticks;
  std::uint64_t from, to;
  SCurve curve;
  std::array<Segment, 2> halves;

  Real from_rate() const { return std::ldexp(static_cast<Real>(from), -64); }
  Real to_rate() const { return std::ldexp(static_cast<Real>(to), -64); }
  // Of constant acceleration.
  Real mean_time() const { return 2 * ticks / (from_rate() + to_rate()); }
  Real mean_acceleration() const { return (to_rate() - from_rate()) / mean_time(); }
};

std::optional<Ramp> ramp_of(std::uint32_t ticks, std::uint64_t from, std::uint64_t to) {
  const auto curve = SCurve::between(ticks, from, to);
  if (!curve) return std::nullopt;
  Ramp ramp{ticks, from, to, *curve, {}};
  curve->set_half(false, ramp.halves[0]);
  curve->set_half(true, ramp.halves[1]);
  return ramp;
}

class RandomRamps {
 public:
  explicit RandomRamps(std::uint64_t seed) : random_(seed) {}

  Ramp next(Real most_clocks) {
    for (;;) {
      const auto ticks = static_cast<std::uint32_t>(std::exp2(uniform(3, 22)));
      const std::uint64_t fast = rate(ticks / std::exp2(uniform(14, 28)));
      // From rest it is the rate in the middle of the first tick.
      const double from_rest = 1 / std::sqrt(2.0 * ticks);
      const double part = one_in(4) ? from_rest : uniform(from_rest, 1);
      const std::uint64_t slow = rate(std::ldexp(static_cast<double>(fast), -64) * part);
      const bool rises = one_in(2);
      const auto ramp = ramp_of(ticks, rises ? slow : fast, rises ? fast : slow);
      // The format of a segment holds so much.
      const bool fits = ramp && 2 * std::abs(ramp->mean_acceleration()) <= 0x1p-22L;
      if (fits && ramp->mean_time() <= most_clocks) return *ramp;
    }
  }

 private:
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  bool one_in(int n) { return random_() % static_cast<unsigned>(n) == 0; }
  static std::uint64_t rate(double per_clock) {
    return static_cast<std::uint64_t>(std::ldexp(std::min(per_clock, 0.5), 64)) + 1;
  }

  std::mt19937_64 random_;
};

// The apex of the exact ramp whose first part has `first` ticks: the area below the rate is that of
// two parabolas, and it is longer the later the apex is where the rate rises.
struct Exact {
  Real time{}, apex{};  // clocks
  std::array<Course, 2> halves;

  Exact(Real from, Real to, Real ticks, Real first) {
    Real low = 0, high = 1;
    for (int i = 0; i < 80; ++i) {
      const Real part = (low + high) / 2;
      set(from, to, ticks, part);
      (halves[0].ticks(apex) < first ? low : high) = part;
    }
  }

 private:
  void set(Real from, Real to, Real ticks, Real part) {
    // Of a time of 1: sums of the rate, which make the ticks with the time.
    const Real change = to - from;
    const auto halves_of = [&](Real all) {
      const Real peak = 2 * change / all, middle = from + peak * part * all / 2;
      return std::array<Course, 2>{Course{from, 0, peak / (part * all)},
                                   Course{middle, peak, -peak / ((1 - part) * all)}};
    };
    const auto unit = halves_of(1);
    time = ticks / (unit[0].ticks(part) + unit[1].ticks(1 - part));
    apex = part * time;
    halves = halves_of(time);
  }
};

TEST(s_curve, runs_on_in_rate_and_acceleration_and_ends_with_both_rates_and_without_acceleration) {
  RandomRamps ramps(1);
  Real off_rate = 0, off_end = 0, off_acceleration = 0, off_peak = -1, least_peak = 1;
  for (int i = 0; i < 100'000; ++i) {
    const Ramp ramp = ramps.next(1e7L);
    ASSERT_EQ(std::uint64_t{ramp.halves[0].ticks} + ramp.halves[1].ticks, ramp.ticks);
    ASSERT_GE(ramp.halves[0].ticks, 1u);
    ASSERT_GE(ramp.halves[1].ticks, 1u);
    const Course first = course_of(ramp.halves[0]), second = course_of(ramp.halves[1]);
    const Real first_time = first.time_of(ramp.halves[0].ticks);
    const Real second_time = second.time_of(ramp.halves[1].ticks);
    const Real peak = 2 * ramp.mean_acceleration();
    // What a jerk's last digit makes.
    const Real digit = std::ldexp(ramp.mean_time(), -84);
    const auto far = [](Real& worst, Real value) { worst = std::max(worst, std::abs(value)); };
    ASSERT_EQ(first.acceleration, 0);
    far(off_rate, first.rate / ramp.from_rate() - 1);
    far(off_rate, first.rate_at(first_time) / second.rate - 1);
    far(off_end, second.rate_at(second_time) / ramp.to_rate() - 1);
    const Real size = std::abs(peak) + 1e5L * digit;
    far(off_acceleration, (first.acceleration_at(first_time) - second.acceleration) / size);
    far(off_acceleration, second.acceleration_at(second_time) / size);
    off_peak = std::max(off_peak, second.acceleration / peak - 1);
    // The apex is less than a tick late.
    least_peak = std::min(least_peak, (second.acceleration / peak - 1) * ramp.ticks);
    const Real clocks = first_time + second_time;
    ASSERT_LE(std::abs(clocks - static_cast<Real>(ramp.curve.clocks())), 2 + clocks * 4e-6L)
        << i << ": " << ramp.ticks << " ticks, " << ramp.from_rate() << " to " << ramp.to_rate();
    ASSERT_GE(clocks, ramp.mean_time() * (1 - 1e-6L));
  }
  std::printf("rate %.1Le, at the end %.1Le, acceleration %.1Le, highest one %+.1Le to %+.2Lf/n\n",
              off_rate, off_end, off_acceleration, off_peak, least_peak);
  EXPECT_LE(off_rate, 1e-5L);
  EXPECT_LE(off_end, 1e-4L);
  EXPECT_LE(off_acceleration, 3e-5L);
  EXPECT_LE(off_peak, 1e-6L);
  EXPECT_GE(least_peak, -1);
}

// The hardware's additions, clock by clock, in its number of digits.
std::vector<std::uint64_t> edges_of(const Ramp& ramp) {
  std::vector<std::uint64_t> edges;
  std::uint64_t clock = 0, phase = 0;
  for (const Segment& half : ramp.halves) {
    std::uint64_t rate = half.rate;
    std::int64_t acceleration = half.acceleration;
    for (std::uint32_t left = half.ticks; left > 0; ++clock) {
      const std::uint64_t before = phase;
      phase += rate;
      rate += static_cast<std::uint64_t>(acceleration >> 20);
      acceleration += half.jerk;
      if (phase >= before) continue;
      edges.push_back(clock + 1);
      --left;
    }
  }
  return edges;
}

// Where a segment ends, up to a clock is lost: so no tick is further off than the fastest one moves
// in it, and in the clock of each edge.
TEST(s_curve, has_its_ticks_at_the_clocks_of_the_exact_cubic) {
  RandomRamps ramps(2);
  Real earliest = 0, latest = 0;
  for (int i = 0; i < 1'000; ++i) {
    const Ramp ramp = ramps.next(4e5L);
    const Real from = ramp.from_rate(), to = ramp.to_rate();
    const Real first = ramp.halves[0].ticks;
    const Exact exact(from, to, ramp.ticks, first);
    // In half of the mean time, the acceleration having risen all the time.
    const Real half = (5 * from + to) / 12 * ramp.mean_time();
    ASSERT_LE(std::abs(first - half), 1.001L) << i;
    const auto edges = edges_of(ramp);
    ASSERT_EQ(edges.size(), ramp.ticks);
    for (std::size_t tick = 1; tick <= edges.size(); ++tick) {
      const Real time = static_cast<Real>(edges[tick - 1]);
      const Real made = time < exact.apex ? exact.halves[0].ticks(time)
                                          : first + exact.halves[1].ticks(time - exact.apex);
      const Real late = (made - static_cast<Real>(tick)) / std::max(from, to);
      earliest = std::min(earliest, late);
      latest = std::max(latest, late);
      ASSERT_GE(late, -1.1L) << "tick " << tick << " of ramp " << i;
      ASSERT_LE(late, 2.1L) << "tick " << tick << " of ramp " << i;
    }
  }
  std::printf("edges %.3Lf to %.3Lf clocks of the fast end behind the cubic\n", earliest, latest);
}

TEST(s_curve, is_the_same_backwards) {
  RandomRamps ramps(3);
  for (int i = 0; i < 20'000; ++i) {
    const Ramp there = ramps.next(1e8L);
    const Ramp back = ramp_of(there.ticks, there.to, there.from).value();
    EXPECT_EQ(there.curve.clocks(), back.curve.clocks());
    for (std::size_t half = 0; half < 2; ++half) {
      EXPECT_EQ(there.halves[half].ticks, back.halves[1 - half].ticks);
      EXPECT_EQ(there.halves[half].jerk, back.halves[1 - half].jerk);
    }
  }
}

TEST(s_curve, is_not_made_of_what_is_too_short_or_too_long) {
  constexpr std::uint64_t slow = std::uint64_t{1} << 40;
  const auto rate = [](double ticks, double clocks) {
    return static_cast<std::uint64_t>(std::ldexp(ticks / clocks, 64));
  };
  for (const std::uint32_t ticks : {8u, 100u, 1000u}) {
    // From rest: the mean is half of the last rate.
    EXPECT_FALSE(SCurve::between(ticks, slow, rate(2 * ticks, 31'900)));
    EXPECT_TRUE(SCurve::between(ticks, slow, rate(2 * ticks, 32'100)));
    EXPECT_TRUE(SCurve::between(ticks, 1, rate(2 * ticks, 0x1p28 * 0.999)));
    EXPECT_FALSE(SCurve::between(ticks, 1, rate(2 * ticks, 0x1p28 * 1.001)));
  }
  EXPECT_FALSE(SCurve::between(7, slow, rate(14, 100'000)));
  EXPECT_FALSE(SCurve::between(100, slow, slow));
}

}  // namespace
