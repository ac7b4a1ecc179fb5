// SPDX-License-Identifier: Apache-2.0
// Milliseconds and microseconds against whole divisions, at the clocks that boards have.
#include "application/tick_clock.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>

namespace application {
namespace {

constexpr std::uint32_t clocks_hz[] = {4'000'000,  12'000'000,  16'000'000, 24'576'000,
                                       50'000'000, 100'000'000, 200'000'000};

TEST(TickClock, counts_ticks_and_microseconds_over_steps_of_any_length) {
  std::mt19937_64 random(1);
  for (const std::uint32_t hz : clocks_hz) {
    TickClock clock{units::Hertz(hz)};
    const std::int64_t tick = hz / 1000;
    std::int64_t at = 0, before = 0;
    for (int i = 0; i < 200'000; ++i) {
      at += static_cast<std::int64_t>(random() >> (63 - random() % 36));
      const Now now = clock.update(units::Cycles(at));
      ASSERT_EQ(now.milliseconds.count(), at / tick) << hz << " Hz, clock " << at;
      const std::int64_t exact = at / tick * 1000 + at % tick * 1000 / tick;
      ASSERT_GE(now.microseconds.count(), exact) << hz << " Hz, clock " << at;
      ASSERT_LE(now.microseconds.count(), exact + 1) << hz << " Hz, clock " << at;
      ASSERT_EQ(now.microseconds.count() / 1000, now.milliseconds.count());
      ASSERT_GE(now.microseconds.count(), before);
      before = now.microseconds.count();
      ASSERT_EQ(clock.next_tick().count(), (at / tick + 1) * tick);
    }
  }
}

TEST(TickClock, begins_each_microsecond_with_its_first_clock) {
  for (const std::uint32_t hz : clocks_hz) {
    if (hz % 1'000'000 != 0) continue;
    TickClock clock{units::Hertz(hz)};
    for (std::int64_t us = 1; us < 5'000; ++us) {
      const std::int64_t first = us * hz / 1'000'000;
      ASSERT_EQ(clock.update(units::Cycles(first - 1)).microseconds.count(), us - 1) << hz;
      ASSERT_EQ(clock.update(units::Cycles(first)).microseconds.count(), us) << hz;
    }
  }
}

TEST(TickClock, converts_lengths_rounded_down) {
  std::mt19937 random(2);
  for (const std::uint32_t hz : clocks_hz) {
    const TickClock clock{units::Hertz(hz)};
    const std::uint32_t tick = hz / 1000;
    for (int i = 0; i < 100'000; ++i) {
      const auto clocks = static_cast<std::uint32_t>(random());
      ASSERT_EQ(clock.ticks_in(clocks), clocks / tick) << hz << " Hz, " << clocks;
      // Up to a second, of which one part in a million may be missing.
      const auto us = static_cast<std::uint32_t>(random() % 1'000'001);
      const std::uint64_t exact = std::uint64_t{us} * tick / 1000;
      ASSERT_LE(clock.clocks_in(us), exact) << hz << " Hz, " << us;
      ASSERT_GE(clock.clocks_in(us) + 1 + exact / 1'000'000, exact) << hz << " Hz, " << us;
    }
  }
}

}  // namespace
}  // namespace application
