// SPDX-License-Identifier: Apache-2.0
// Heating that does not heat, and heat that is lost.
#include "thermal/protection.hpp"

#include <gtest/gtest.h>

#include "tests/thermal/ntc.hpp"

namespace {

using tests::celsius;
using thermal::Fault;
using units::Milliseconds;

struct Guarded : testing::Test {
  thermal::Protection protection{thermal::ProtectionSettings{}};
  std::int64_t now = 0;
  double degrees = 25;

  // The first fault while the temperature changes at `slope`, in degrees per second.
  std::optional<Fault> run(double target, double slope, double seconds) {
    for (double t = 0; t < seconds; t += 0.1) {
      now += 100;
      degrees += slope / 10;
      if (const auto fault =
              protection.update(celsius(target), celsius(degrees), Milliseconds(now))) {
        return fault;
      }
    }
    return std::nullopt;
  }
};

TEST_F(Guarded, is_content_with_a_slow_heater) { EXPECT_EQ(run(60, 0.12, 280), std::nullopt); }

TEST_F(Guarded, misses_the_rise_of_two_degrees_in_twenty_seconds) {
  EXPECT_EQ(run(200, 0.05, 19.9), std::nullopt);
  EXPECT_EQ(run(200, 0.05, 0.5), Fault::heating_failed);
}

TEST_F(Guarded, misses_the_rise_half_way_too) {
  EXPECT_EQ(run(200, 1.5, 60), std::nullopt);
  EXPECT_EQ(run(200, 0, 22), Fault::heating_failed);
}

TEST_F(Guarded, gives_the_rise_its_time_again_after_a_pause) {
  EXPECT_EQ(run(200, 1.5, 60), std::nullopt);
  EXPECT_EQ(run(200, -0.3, 15), std::nullopt);
  protection.pause();
  EXPECT_EQ(run(200, 0, 19.9), std::nullopt);
  EXPECT_EQ(run(200, 0, 0.5), Fault::heating_failed);
}

TEST_F(Guarded, a_pause_does_not_put_off_a_runaway) {
  EXPECT_EQ(run(200, 2, 87.5), std::nullopt);
  EXPECT_EQ(run(200, -1, 6), std::nullopt);
  for (int i = 0; i < 36; ++i) {
    EXPECT_EQ(run(200, 0, 0.95), std::nullopt);
    protection.pause();
  }
  EXPECT_EQ(run(200, 0, 4), Fault::thermal_runaway);
}

TEST_F(Guarded, finds_a_runaway_after_forty_seconds) {
  EXPECT_EQ(run(200, 2, 87.5), std::nullopt);
  EXPECT_EQ(run(200, -1, 6), std::nullopt);
  EXPECT_EQ(run(200, 0, 37), std::nullopt);
  EXPECT_EQ(run(200, 0, 3), Fault::thermal_runaway);
}

TEST_F(Guarded, forgives_a_short_drop) {
  EXPECT_EQ(run(200, 2, 87.5), std::nullopt);
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(run(200, -1, 6), std::nullopt);
    EXPECT_EQ(run(200, 0, 25), std::nullopt);
    EXPECT_EQ(run(200, 1, 6), std::nullopt);
  }
}

TEST_F(Guarded, lets_a_lower_target_cool_down) {
  EXPECT_EQ(run(200, 2, 87.5), std::nullopt);
  protection.restart();
  EXPECT_EQ(run(150, -0.5, 90), std::nullopt);
  EXPECT_EQ(run(150, 0, 100), std::nullopt);
}

}  // namespace
