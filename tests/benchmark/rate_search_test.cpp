// SPDX-License-Identifier: Apache-2.0
// The search finds the shortest interval at which each rule holds, and does not trust one alone.
#include "tools/benchmark/rate_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

using benchmarks::Limits;
using benchmarks::RateSearch;
using benchmarks::Trial;

constexpr double tolerance = 50;

// A source of steps that is clean from one interval on, with a lateness that falls
// towards longer ones.
struct Stepper {
  std::uint32_t clean_from{};
  std::uint32_t late_clocks_at_zero{};
  std::vector<std::uint32_t> dirty{};
  std::vector<std::uint32_t> runs{};

  Trial run(std::uint32_t interval) {
    runs.push_back(interval);
    if (interval < clean_from || std::ranges::contains(dirty, interval)) return {"late", 0};
    const std::uint32_t late = interval < late_clocks_at_zero ? late_clocks_at_zero - interval : 0;
    return {"", static_cast<double>(late)};
  }
  Limits limits(std::uint32_t start, double fineness = 0) {
    return RateSearch([this](std::uint32_t interval, double) { return run(interval); }, tolerance,
                      fineness)
        .limits(start);
  }
};

TEST(rate_search, finds_each_limit_to_the_clock) {
  for (const std::uint32_t clean_from : {3u, 7u, 100u, 313u, 4'711u}) {
    Stepper stepper{.clean_from = clean_from, .late_clocks_at_zero = clean_from + 120};
    const Limits limits = stepper.limits(2);
    EXPECT_EQ(limits.clean.interval_clocks, clean_from);
    EXPECT_EQ(limits.clean.largest_lateness_clocks, 120);
    EXPECT_EQ(limits.clean.limited_by, "late");
    EXPECT_EQ(limits.punctual.interval_clocks, clean_from + 70);
    EXPECT_EQ(limits.punctual.largest_lateness_clocks, 50);
    EXPECT_EQ(limits.punctual.limited_by, "ticks beyond the tolerance");
    EXPECT_EQ(limits.clean.also_clocks + limits.punctual.also_clocks, 0u);
  }
}

TEST(rate_search, one_clock_more_than_the_tolerance_is_not_punctual) {
  Stepper stepper{.clean_from = 300, .late_clocks_at_zero = 350};
  EXPECT_EQ(stepper.limits(2).punctual.interval_clocks, 300u);
  stepper.late_clocks_at_zero = 351;
  EXPECT_EQ(stepper.limits(2).punctual.interval_clocks, 301u);
}

TEST(rate_search, what_is_bound_by_nothing_is_at_the_shortest_interval) {
  Stepper stepper;
  const Limits limits = stepper.limits(2);
  EXPECT_EQ(limits.clean.interval_clocks, 2u);
  EXPECT_EQ(limits.punctual.interval_clocks, 2u);
  EXPECT_EQ(limits.punctual.limited_by, "");
}

TEST(rate_search, does_not_accept_a_rate_where_a_slightly_lower_one_fails) {
  Stepper stepper{.clean_from = 100, .dirty = {103}};
  const Limits limits = stepper.limits(2);
  EXPECT_EQ(limits.clean.interval_clocks, 104u);
  EXPECT_EQ(limits.clean.also_clocks, 100u);
  EXPECT_EQ(limits.punctual.interval_clocks, 104u);
}

TEST(rate_search, a_run_reports_both_rules_and_is_made_once) {
  Stepper stepper{.clean_from = 300, .late_clocks_at_zero = 500};
  stepper.limits(2);
  std::ranges::sort(stepper.runs);
  EXPECT_EQ(std::ranges::adjacent_find(stepper.runs), stepper.runs.end());
}

TEST(rate_search, a_coarse_search_is_right_to_its_fineness) {
  Stepper stepper{.clean_from = 1'000, .late_clocks_at_zero = 1'500};
  const Limits limits = stepper.limits(100, 1.0 / 50);
  EXPECT_GE(limits.clean.interval_clocks, 1'000u);
  EXPECT_LE(limits.clean.interval_clocks, 1'022u);
  EXPECT_GE(limits.punctual.interval_clocks, 1'450u);
  EXPECT_LE(limits.punctual.interval_clocks, 1'480u);
}

TEST(rate_search, says_so_where_no_rate_will_do) {
  Stepper stepper{.clean_from = 1'000'000};
  EXPECT_THROW(stepper.limits(2), std::runtime_error);
}

TEST(rate_search, a_run_for_the_clean_rate_is_not_ended_by_a_late_tick) {
  const auto run = [](std::uint32_t interval, double late_enough) -> Trial {
    if (interval < 200) return {"late", 0};
    const double late = interval < 300 ? 80 : 0;
    return {late > late_enough ? "ended" : "", late};
  };
  RateSearch search(run, tolerance, 0);
  const Limits limits = search.limits(2);
  EXPECT_EQ(limits.clean.interval_clocks, 200u);
  EXPECT_EQ(limits.clean.largest_lateness_clocks, 80);
  EXPECT_EQ(limits.punctual.interval_clocks, 300u);
}

}  // namespace
