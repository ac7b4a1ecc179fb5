// SPDX-License-Identifier: Apache-2.0
// What a held temperature needs: more than draught, supply, fan and filament explain, or not.
#include "thermal/demand.hpp"

#include <gtest/gtest.h>

#include "machine/machine.hpp"

namespace {

using thermal::Demand;
using thermal::Slopes;

constexpr std::int32_t window_ms = 1'000;
constexpr std::int32_t lost = 800;  // mK/s in still air, at the target
constexpr std::int32_t part = Demand::Power::scale;

struct Needed : testing::Test {
  Demand demand{machine::machine.hotend.model};

  // True if a heater of the nominal power is found to need too much within `windows`.
  bool grows(int windows, const Slopes& slopes, std::int32_t power = part) {
    bool grown = false;
    for (int i = 0; i < windows; ++i) {
      if (demand.add(slopes, window_ms)) grown = grown || demand.has_grown({power, power});
    }
    return grown;
  }
};

constexpr Slopes still(std::int32_t heating, std::int32_t measured = 0) {
  return {.measured = measured, .heating = heating, .still = lost};
}

TEST_F(Needed, finds_a_need_that_doubles_within_twelve_windows) {
  EXPECT_FALSE(grows(12, still(lost)));
  EXPECT_TRUE(grows(12, still(2 * lost)));
}

TEST_F(Needed, counts_heat_that_the_temperature_takes_up) {
  EXPECT_FALSE(grows(12, still(2 * lost, lost)));
  EXPECT_TRUE(grows(12, still(2 * lost)));
}

TEST_F(Needed, counts_a_temperature_that_falls) {
  EXPECT_FALSE(grows(12, still(lost)));
  EXPECT_TRUE(grows(12, still(lost, -lost)));
}

TEST_F(Needed, takes_heat_by_the_power_of_the_heater) {
  // With half the power the slope was all that it gave, so it needed nothing then.
  EXPECT_FALSE(grows(12, still(2 * lost, lost), part));
  EXPECT_TRUE(grows(12, still(2 * lost, lost / 2), part / 2));
}

TEST_F(Needed, bears_draught_and_a_weaker_supply_at_once) {
  EXPECT_FALSE(grows(60, still(lost)));
  EXPECT_FALSE(grows(60, still(lost * 13 / 10 * 10 / 8)));
}

TEST_F(Needed, bears_a_need_that_falls) {
  EXPECT_FALSE(grows(60, still(2 * lost)));
  EXPECT_FALSE(grows(60, still(lost / 4)));
}

TEST_F(Needed, bears_what_fan_and_filament_explain) {
  EXPECT_FALSE(grows(60, still(lost)));
  EXPECT_FALSE(
      grows(60, {.heating = 2 * lost, .still = lost, .blown = lost / 4, .melted = lost / 4}));
  EXPECT_TRUE(
      grows(12, {.heating = 5 * lost, .still = lost, .blown = lost / 4, .melted = lost / 4}));
}

TEST_F(Needed, bears_a_need_that_grows_slowly) {
  for (std::int32_t heating = lost; heating < 3 * lost; heating += lost / 8) {
    EXPECT_FALSE(grows(20, still(heating))) << heating;
  }
}

TEST_F(Needed, bears_a_heater_without_described_losses) {
  EXPECT_FALSE(grows(12, {.heating = lost}));
  EXPECT_FALSE(grows(12, {.heating = 3 * lost}));
}

TEST_F(Needed, knows_nothing_of_another_target) {
  EXPECT_FALSE(grows(60, still(lost)));
  demand.restart();
  EXPECT_FALSE(grows(60, still(3 * lost)));
}

TEST_F(Needed, compares_nothing_with_a_much_colder_block) {
  EXPECT_FALSE(grows(12, {.heating = lost / 3, .still = lost / 3}));
  EXPECT_FALSE(grows(60, still(3 * lost)));
}

// As while it heats up.
TEST_F(Needed, grows_by_more_than_a_warmer_block_loses) {
  EXPECT_FALSE(grows(12, {.heating = lost * 2 / 3, .still = lost * 2 / 3}));
  EXPECT_FALSE(grows(60, still(lost)));
  EXPECT_TRUE(grows(60, still(3 * lost)));
}

}  // namespace
