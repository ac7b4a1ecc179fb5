// SPDX-License-Identifier: Apache-2.0
// Heat that goes missing, heat that was not requested, and what is neither.
#include "thermal/plausibility.hpp"

#include <gtest/gtest.h>

#include "machine/machine.hpp"
#include "tests/thermal/ntc.hpp"

namespace {

using tests::celsius;
using thermal::Plausibility;
using Finding = Plausibility::Finding;

struct Compared : testing::Test {
  Plausibility plausibility{machine::machine.hotend.model};
  double degrees = 25;

  // The first finding while the temperature changes at `slope`, in degrees per second.
  Finding run(double slope, double seconds, thermal::Duty duty) {
    for (double t = 0; t < seconds; t += 0.1) {
      degrees += slope / 10;
      const Finding finding = plausibility.update(
          celsius(degrees), duty, duty != 0 ? std::optional(celsius(205)) : std::nullopt, {},
          units::Milliseconds(100));
      if (finding != Finding::none) return finding;
    }
    return Finding::none;
  }
};

TEST_F(Compared, finds_a_heater_that_is_stuck_on) {
  EXPECT_EQ(run(0, 100, 0), Finding::none);
  EXPECT_EQ(run(1.5, 5, 0), Finding::heat_unasked);
}

TEST_F(Compared, finds_a_slow_heater_that_is_stuck_on) {
  EXPECT_EQ(run(0.2, 30, 0), Finding::heat_unasked);
}

TEST_F(Compared, takes_neither_late_heat_nor_a_warm_day_for_a_stuck_heater) {
  EXPECT_EQ(run(2.5, 60, thermal::full_duty), Finding::none);
  EXPECT_EQ(run(2.5, 1, 0), Finding::none);
  EXPECT_EQ(run(1, 2, 0), Finding::none);
  EXPECT_EQ(run(-1, 50, 0), Finding::none);
  EXPECT_EQ(run(0.005, 4'000, 0), Finding::none);
}

TEST_F(Compared, finds_heat_that_goes_missing) {
  EXPECT_EQ(run(2.5, 30, thermal::full_duty), Finding::none);
  EXPECT_EQ(run(0, 6, thermal::full_duty), Finding::heat_missing);
}

// A loose wire: one conversion in two seconds is faulty.
TEST_F(Compared, finds_faults_between_faulty_conversions) {
  const auto run_with_faulty = [this](double slope, double seconds, thermal::Duty duty) {
    Finding finding = Finding::none;
    for (double t = 0; t < seconds && finding == Finding::none; t += 2) {
      finding = run(slope, 1.9, duty);
      if (finding == Finding::none) {
        finding = plausibility.update(std::nullopt, duty,
                                      duty != 0 ? std::optional(celsius(205)) : std::nullopt, {},
                                      units::Milliseconds(100));
      }
    }
    return finding;
  };
  EXPECT_EQ(run_with_faulty(2.5, 30, thermal::full_duty), Finding::none);
  EXPECT_EQ(run_with_faulty(0, 10, thermal::full_duty), Finding::heat_missing);
  EXPECT_EQ(run_with_faulty(0, 60, 0), Finding::none);
  EXPECT_EQ(run_with_faulty(1.5, 10, 0), Finding::heat_unasked);
}

TEST_F(Compared, bears_a_single_wild_conversion) {
  EXPECT_EQ(run(0, 20, 0), Finding::none);
  for (const double wild : {-60.0, 60.0}) {
    plausibility.update(celsius(degrees + wild), 0, std::nullopt, {}, units::Milliseconds(100));
    EXPECT_EQ(run(0, 20, 0), Finding::none) << wild;
  }
}

TEST_F(Compared, says_nothing_of_a_heater_that_is_not_described) {
  Plausibility blind{thermal::no_heater_model};
  for (int i = 0; i < 1'000; ++i) {
    EXPECT_EQ(blind.update(celsius(25 + i), 0, std::nullopt, {}, units::Milliseconds(100)),
              Finding::none);
  }
}

}  // namespace
