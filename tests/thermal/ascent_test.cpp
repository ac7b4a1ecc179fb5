// SPDX-License-Identifier: Apache-2.0
// A reading that does not follow the heat while it gets hotter, and heaters that are only weak.
#include "thermal/ascent.hpp"

#include <gtest/gtest.h>

#include "machine/machine.hpp"

namespace {

using thermal::Ascent;
using Finding = Ascent::Finding;

// A bed at a target of 60 degrees, far below it, with readings of which a test says how they rise.
struct Climbing : testing::Test {
  const thermal::HeaterModel& model = machine::machine.bed.model;
  Ascent ascent{model};
  std::int32_t still = 0;  // mK/s lost in still air
  std::int32_t below = 20'000;
  bool reached = false;

  // Seconds until a finding, at most so many; `heating` in parts of full power.
  int run(Finding expected, double slope, int seconds, double heating = 1) {
    for (int i = 1; i <= seconds; ++i) {
      const Finding finding =
          ascent.add({.slopes = {.measured = static_cast<std::int32_t>(slope * model.rise),
                                 .heating = static_cast<std::int32_t>(heating * model.rise),
                                 .still = still},
                      .needed = model.rise / 2,
                      .below = below,
                      .reached = reached,
                      .noise = 50,
                      .milliseconds = 1'000});
      if (finding == Finding::none) continue;
      EXPECT_EQ(finding, expected);
      return i;
    }
    return seconds + 1;
  }
};

TEST_F(Climbing, a_reading_that_stops_is_behind) {
  EXPECT_EQ(run(Finding::none, 0.9, 60), 61);
  EXPECT_LE(run(Finding::behind, 0, 20), 6);
}

TEST_F(Climbing, a_reading_that_never_moves_is_behind_the_weakest_heater) {
  EXPECT_LE(run(Finding::behind, 0, 20), 10);
}

TEST_F(Climbing, the_weakest_heater_is_not_behind) {
  EXPECT_EQ(run(Finding::none, model.least_power / 100.0, 300), 301);
}

TEST_F(Climbing, what_the_heater_has_shown_counts_until_another_may_be_mounted) {
  const double weakest = model.least_power / 100.0;
  EXPECT_EQ(run(Finding::none, 1.2, 60), 61);
  EXPECT_LE(run(Finding::behind, weakest / 2, 60), 60);
  ascent.restart();
  ascent.forget();
  EXPECT_EQ(run(Finding::none, weakest / 2 + 0.1, 300), 301);
}

TEST_F(Climbing, a_supply_that_falls_while_a_draught_begins_is_no_fault) {
  still = model.rise / 5;
  EXPECT_EQ(run(Finding::none, 0.8, 60), 61);
  EXPECT_EQ(run(Finding::none, 0.8 - 0.2 - 0.2 * model.draught / 100, 300), 301);
}

TEST_F(Climbing, a_reading_that_stands_still_is_behind_where_wind_could_take_all_the_heat) {
  still = model.rise;
  EXPECT_LE(run(Finding::behind, 0, 20), 16);
}

TEST_F(Climbing, a_reading_that_stands_still_at_the_target_is_none) {
  still = model.rise;
  reached = true;
  EXPECT_EQ(run(Finding::none, 0, 300), 301);
  reached = false;
  below = 500;
  EXPECT_EQ(run(Finding::none, 0, 300), 301);
}

TEST_F(Climbing, a_reading_that_creeps_is_none) {
  still = model.rise;
  EXPECT_EQ(run(Finding::none, 0.05, 300), 301);
}

TEST_F(Climbing, a_reading_faster_than_the_strongest_heater_is_ahead) {
  EXPECT_EQ(run(Finding::none, model.most_power / 100.0, 300), 301);
  EXPECT_LE(run(Finding::ahead, 4, 20), 5);
}

TEST_F(Climbing, little_heat_shows_nothing) { EXPECT_EQ(run(Finding::none, 0, 300, 0.4), 301); }

}  // namespace
