// SPDX-License-Identifier: Apache-2.0
// Lateness of ticks is reported to the clock, whatever else is wrong with them.
#include "tools/benchmark/lateness.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using benchmarks::largest_lateness;
using benchmarks::largest_lateness_in_even_series;
using Ticks = std::vector<sim::Clock>;

constexpr sim::Clock first = 1'234'567;

// Each in the first clock at or after its instant, as the step generator makes them.
Ticks exact_ticks(double interval_clocks, std::size_t count) {
  Ticks ticks;
  for (std::size_t i = 0; i < count; ++i) {
    const double instant = interval_clocks * static_cast<double>(i);
    ticks.push_back(first + static_cast<sim::Clock>(std::ceil(instant)));
  }
  return ticks;
}

TEST(lateness, exact_ticks_are_not_late) {
  EXPECT_EQ(largest_lateness(exact_ticks(2, 1000), 2), 0);
  EXPECT_EQ(largest_lateness(exact_ticks(1000, 1000), 1000), 0);
  EXPECT_LT(largest_lateness(exact_ticks(3.3, 1000), 3.3), 1);
}

TEST(lateness, a_single_late_tick_is_reported_to_the_clock) {
  for (const sim::Clock late : {1u, 49u, 50u, 51u, 500u}) {
    for (const std::size_t place : {0u, 1u, 500u, 999u}) {
      Ticks ticks = exact_ticks(1000, 1000);
      ticks[place] += late;
      EXPECT_EQ(largest_lateness(ticks, 1000), late) << "tick " << place;
    }
  }
}

TEST(lateness, what_delays_all_ticks_alike_delays_none) {
  Ticks ticks = exact_ticks(300, 1000);
  for (sim::Clock& tick : ticks) tick += 40;
  EXPECT_EQ(largest_lateness(ticks, 300), 0);
}

TEST(lateness, a_delay_that_stays_counts_once_and_delays_add_up) {
  Ticks ticks = exact_ticks(300, 1000);
  for (std::size_t i = 400; i < ticks.size(); ++i) ticks[i] += 30;
  EXPECT_EQ(largest_lateness(ticks, 300), 30);
  for (std::size_t i = 700; i < ticks.size(); ++i) ticks[i] += 21;
  EXPECT_EQ(largest_lateness(ticks, 300), 51);
}

TEST(lateness, a_missing_tick_makes_those_after_it_late_by_an_interval) {
  Ticks ticks = exact_ticks(300, 1000);
  ticks.erase(ticks.begin() + 500);
  EXPECT_EQ(largest_lateness(ticks, 300), 300);
}

TEST(lateness, an_extra_tick_makes_those_before_it_late_by_an_interval) {
  Ticks ticks = exact_ticks(300, 1000);
  ticks.insert(ticks.begin() + 500, ticks[499] + 150);
  EXPECT_EQ(largest_lateness(ticks, 300), 300);
}

TEST(lateness, a_rate_that_is_not_held_adds_up) {
  EXPECT_NEAR(largest_lateness(exact_ticks(1000.1, 1001), 1000), 100, 1);
}

TEST(lateness, a_run_that_is_watched_reports_the_same) {
  Ticks ticks = exact_ticks(300, 1000);
  ticks[0] += 20;
  ticks[600] += 45;
  benchmarks::RunningLateness lateness(300);
  lateness.add(std::span(ticks).first(1));
  EXPECT_EQ(lateness.clocks(), 0);
  lateness.add(std::span(ticks).first(600));
  EXPECT_EQ(lateness.clocks(), 20);
  lateness.add(ticks);
  EXPECT_EQ(lateness.clocks(), 45);
}

TEST(lateness, nothing_is_late_where_nothing_is_made) {
  EXPECT_EQ(largest_lateness({}, 100), 0);
  EXPECT_EQ(largest_lateness_in_even_series({}), 0);
  EXPECT_EQ(largest_lateness_in_even_series(exact_ticks(100, 1)), 0);
}

TEST(lateness, an_even_series_is_found_at_any_interval) {
  EXPECT_EQ(largest_lateness_in_even_series(exact_ticks(2, 10'000)), 0);
  for (const double interval : {3.3, 276.000'4, 312.123'456}) {
    EXPECT_LT(largest_lateness_in_even_series(exact_ticks(interval, 10'000)), 1.01) << interval;
  }
}

TEST(lateness, late_ticks_show_against_the_even_series_of_the_others) {
  for (const sim::Clock late : {49u, 50u, 51u, 500u}) {
    Ticks ticks = exact_ticks(276.000'4, 10'000);
    ticks[2'500] += late;
    ticks[7'500] += late;
    EXPECT_NEAR(largest_lateness_in_even_series(ticks), static_cast<double>(late), 1.01);
  }
}

TEST(lateness, a_pause_shows_against_any_even_series) {
  Ticks ticks = exact_ticks(300, 10'000);
  for (std::size_t i = 5'000; i < ticks.size(); ++i) ticks[i] += 1'000;
  EXPECT_GT(largest_lateness_in_even_series(ticks), 400);
}

TEST(lateness, axes_that_step_at_once_make_one_tick) {
  std::array<benchmarks::PinWatch::Axis, benchmarks::axes> pins;
  pins[0].rises = {100, 200, 300, 400};
  pins[1].rises = {100, 300};
  pins[3].rises = {200, 400};
  EXPECT_EQ(benchmarks::ticks_of(pins), (Ticks{100, 200, 300, 400}));
  pins[3].rises = {200, 401};
  EXPECT_EQ(benchmarks::ticks_of(pins), (Ticks{100, 200, 300, 400, 401}));
}

}  // namespace
