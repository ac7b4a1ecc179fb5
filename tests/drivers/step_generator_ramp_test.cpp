// SPDX-License-Identifier: Apache-2.0
// Ticks against the exact third-order ramp in closed form: each comes with the first clock edge
// after its exact instant.
#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "tests/drivers/step_generator_fixture.hpp"

namespace {

using motion::Segment;

// rate(t) = rate + acceleration t + jerk t^2 / 2, in ticks and clocks.
struct Ramp {
  long double rate{}, acceleration{}, jerk{};

  // From one rate to another in so many clocks. Bend -1 .. 1: all of the change at the start,
  // evenly (0), or all at the end; always monotonous.
  static Ramp between(long double from, long double to, long double clocks, long double bend) {
    const long double change = (to - from) / clocks;
    return {from, (1 - bend) * change, 2 * bend * change / clocks};
  }

  long double ticks_at(long double t) const {
    return ((jerk / 6 * t + acceleration / 2) * t + rate) * t;
  }
  long double rate_at(long double t) const { return (jerk / 2 * t + acceleration) * t + rate; }

  // Sums of what is added in each clock are the ramp itself at the clock edges
  // (Newton's forward differences).
  void put(Segment& segment) const {
    segment.rate =
        static_cast<std::uint64_t>(std::roundl(std::ldexp(rate + acceleration / 2 + jerk / 6, 64)));
    segment.acceleration =
        static_cast<std::int64_t>(std::roundl(std::ldexp(acceleration + jerk, 84)));
    segment.jerk = static_cast<std::int64_t>(std::roundl(std::ldexp(jerk, 84)));
  }
};

// Bounds that the header of rtl/motion/time_base.vhd derives.
long double tick_error_after(long double clocks) {
  const long double truncation = std::ldexp(1.0L, -64), rounding = std::ldexp(1.0L, -85);
  return clocks * truncation / 2 + clocks * clocks / 2 * (truncation + rounding) +
         clocks * clocks * clocks / 6 * rounding;
}
long double rate_error_after(long double clocks) {
  const long double truncation = std::ldexp(1.0L, -64), rounding = std::ldexp(1.0L, -85);
  return truncation / 2 + clocks * (truncation + rounding) + clocks * clocks / 2 * rounding;
}

class StepGeneratorRampTest : public tests::StepGeneratorFixture {
 protected:
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(random_()) / 4294967296.0;
  }

  // Rates of 2^-12 up to a given power of two; the ramp's length is between 2^8 and 2^14 clocks.
  Ramp random_ramp(double highest_rate_log2) {
    clocks_ = std::exp2(uniform(8, 14));
    // An acceleration, at most twice the mean one, is below 2^-21.
    const double most_change = std::ldexp(clocks_, -22);
    const double from = std::exp2(uniform(-12, highest_rate_log2));
    const double to = std::clamp(std::exp2(uniform(-12, highest_rate_log2)), from - most_change,
                                 from + most_change);
    return Ramp::between(from, to, clocks_, uniform(-1, 1));
  }

  // Calls `judge(tick, clocks since the motion began)` at each tick of the first axis, which the
  // pins show a clock later.
  template <typename Judge>
  void watch_ticks(Judge judge) {
    chip_.after_clock = [this, judge, step = 0u, moving = false,
                         began = std::uint64_t{}]() mutable {
      if (chip_->moving && !moving) began = chip_.now();
      moving = chip_->moving;
      const bool rises = (chip_->step & 1u) != 0 && (step & 1u) == 0;
      step = chip_->step;
      if (rises) judge(++ticks_, static_cast<long double>(chip_.now() - pin_delay - began));
    };
  }

  // Makes the ramp's ticks, as a segment of its own. Returns how many.
  std::int32_t execute(const Ramp& ramp) {
    const auto count = static_cast<std::int32_t>(ramp.ticks_at(clocks_));
    if (count == 0) return 0;
    Segment segment = line({count, 0, 0, 0});
    ramp.put(segment);
    ticks_ = 0;
    append(segment);
    run_until_idle();
    EXPECT_EQ(ticks_, static_cast<std::uint64_t>(count));
    return count;
  }

 private:
  static constexpr std::uint64_t pin_delay = 1;
  std::mt19937 random_{7};
  double clocks_{};
  std::uint64_t ticks_{};
};

TEST_F(StepGeneratorRampTest, makes_each_tick_at_the_first_clock_edge_after_its_exact_instant) {
  Ramp ramp;
  watch_ticks([&ramp](std::uint64_t tick, long double clocks) {
    const auto wanted = static_cast<long double>(tick);
    const long double error = tick_error_after(clocks) + 1e-14L;  // of this arithmetic
    ASSERT_GE(ramp.ticks_at(clocks), wanted - error) << "early at tick " << tick;
    ASSERT_LT(ramp.ticks_at(clocks - 1), wanted + error) << "late at tick " << tick;
  });
  std::int64_t all_ticks = 0;
  for (int i = 0; i < 2000 && !HasFailure(); ++i) {
    ramp = random_ramp(-1.3);
    all_ticks += execute(ramp);
  }
  EXPECT_GT(all_ticks, 100000);
}

// The bounds of rtl/motion/feed_override.vhd.
TEST_F(StepGeneratorRampTest, places_ticks_within_the_bounds_of_the_override) {
  Ramp ramp;
  long double scale = 1;
  watch_ticks([&ramp, &scale](std::uint64_t tick, long double clocks) {
    const long double base_clocks = scale * clocks;
    const auto wanted = static_cast<long double>(tick);
    const long double lag = scale > 1 ? 4 : 1, error = scale > 1 ? 0.25L : 1e-9L;
    ASSERT_GE(ramp.ticks_at(base_clocks), wanted - error) << "early at tick " << tick;
    ASSERT_LT(ramp.ticks_at(base_clocks - scale - lag), wanted + error) << "late, tick " << tick;
  });
  std::int64_t all_ticks = 0;
  for (int i = 0; i < 300 && !HasFailure(); ++i) {
    const double wanted = i % 3 == 0   ? uniform(6554, 65536)
                          : i % 3 == 1 ? uniform(65536, 262143)
                                       : 65536.0 * (1 + i % 4);
    const std::uint32_t scale_65536ths = std::min(static_cast<std::uint32_t>(wanted), 262143u);
    scale = scale_65536ths / 65536.0L;
    generator_.set_override(scale_65536ths);
    ramp = random_ramp(-3.3);
    all_ticks += execute(ramp);
  }
  EXPECT_GT(all_ticks, 10000);
}

// A hundred million clocks are 2 s at 50 MHz. The netlist and the arithmetic of its specification
// make the same ticks in the same clocks; the arithmetic's end rate is off by less than 1 tick/s.
TEST_F(StepGeneratorRampTest, whole_keeps_rate_and_count_over_a_hundred_million_clocks) {
  constexpr std::uint64_t clocks = 100'000'000;
  constexpr long double clock_hz = 50e6;
  const Ramp ramp = Ramp::between(1e-6L, 0.02L, static_cast<long double>(clocks), 0.7L);
  const auto count = static_cast<std::int32_t>(ramp.ticks_at(static_cast<long double>(clocks)));
  Segment segment = line({count, 0, 0, 0});
  ramp.put(segment);
  std::uint64_t began = 0;
  chip_.after_clock = [&] {
    if (chip_->moving && began == 0) began = chip_.now();
  };
  append(segment);
  ASSERT_TRUE(chip_->moving);

  std::uint64_t phase = 0, rate = segment.rate;
  auto acceleration = static_cast<std::uint64_t>(segment.acceleration);
  std::uint64_t since_start = 0, ticks = 0;
  bool was_high = false;
  bool is_due = false;  // a tick of the clock before, which the pins show now
  const auto model = [&] {
    phase += rate;
    const bool tick = phase < rate;
    rate += static_cast<std::uint64_t>(static_cast<std::int64_t>(acceleration) >> 20);
    acceleration += static_cast<std::uint64_t>(segment.jerk);
    ++since_start;
    return tick;
  };
  // The clocks since motion began, in which the driver's last access ended.
  for (std::uint64_t clock = began; clock < chip_.now(); ++clock) ASSERT_FALSE(model());
  while (since_start < clocks) {
    const bool tick = model();
    chip_->clk = chip_->always_clk = 1;
    chip_->eval();
    chip_->clk = chip_->always_clk = 0;
    chip_->eval();
    const bool is_high = (chip_->step & 1u) != 0;
    ASSERT_EQ(is_high && !was_high, std::exchange(is_due, tick)) << since_start;
    was_high = is_high;
    if (!tick) continue;
    ++ticks;
    const auto now = static_cast<long double>(since_start);
    const auto wanted = static_cast<long double>(ticks);
    ASSERT_GE(ramp.ticks_at(now), wanted - tick_error_after(now) - 1e-9L);
    ASSERT_LT(ramp.ticks_at(now - 1), wanted + tick_error_after(now) + 1e-9L);
  }
  const auto end = static_cast<long double>(since_start);
  const long double end_rate = std::ldexp(static_cast<long double>(rate), -64);
  // The rate of the next clock is the ramp's mean in it.
  const long double exact = ramp.ticks_at(end + 1) - ramp.ticks_at(end);
  EXPECT_LT(std::fabs(end_rate - exact), rate_error_after(end));
  EXPECT_LT(std::fabs(end_rate - exact) * clock_hz, 1);
  EXPECT_EQ(ticks, static_cast<std::uint64_t>(ramp.ticks_at(end)));
  std::printf("end rate off by %.6Lf tick/s of %.0Lf, %llu ticks\n",
              std::fabs(end_rate - exact) * clock_hz, exact * clock_hz,
              static_cast<unsigned long long>(ticks));
}

}  // namespace
