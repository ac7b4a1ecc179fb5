// SPDX-License-Identifier: Apache-2.0
// Waiting for a temperature as M109 does.
#include <gtest/gtest.h>

#include "tests/thermal/ntc.hpp"
#include "thermal/arrival.hpp"

namespace {

using tests::celsius;
using units::Milliseconds;

constexpr auto target = celsius(200);

struct Wait : testing::Test {
  thermal::Arrival arrival{thermal::ArrivalSettings{.residency = Milliseconds(5'000)}};
  std::int64_t now = 0;

  void hold(double degrees, std::int64_t milliseconds) {
    for (const std::int64_t end = now + milliseconds; now < end;) {
      now += 100;
      arrival.update(target, celsius(degrees), Milliseconds(now));
    }
  }
};

TEST_F(Wait, ends_when_the_target_was_held_for_the_residency) {
  hold(198.9, 60'000);
  EXPECT_FALSE(arrival.arrived());
  EXPECT_EQ(arrival.time_left(Milliseconds(now)), std::nullopt);
  hold(199.1, 4'900);
  EXPECT_FALSE(arrival.arrived());
  EXPECT_LE(arrival.time_left(Milliseconds(now))->count(), 200);
  hold(200.5, 300);
  EXPECT_TRUE(arrival.arrived());
}

TEST_F(Wait, bears_the_hysteresis_and_starts_over_beyond_it) {
  hold(200, 1'000);
  hold(202.9, 2'000);
  hold(203.1, 100);
  hold(200, 4'900);
  EXPECT_FALSE(arrival.arrived());
  hold(200, 200);
  EXPECT_TRUE(arrival.arrived());
}

TEST_F(Wait, is_over_once_and_for_all_until_it_restarts) {
  hold(200, 6'000);
  hold(150, 1'000);
  EXPECT_TRUE(arrival.arrived());
  arrival.restart();
  EXPECT_FALSE(arrival.arrived());
}

}  // namespace
