// SPDX-License-Identifier: Apache-2.0
// One mode of vibration: its period, its decay, and that it does not gain energy.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sim/plants/vibration.hpp"

namespace plants_test {
namespace {

TEST(vibration, swings_with_its_period_and_decays_with_its_damping) {
  const double damping = 0.1;
  plants::Vibration mode(40, damping);
  mode.move_to(0.01, 1);
  EXPECT_NEAR(mode.deflection(), -1, 1e-12);
  const double period = 1 / (40 * std::sqrt(1 - damping * damping));
  mode.advance(0.01 + 0.3 * period);
  const double before = mode.deflection();
  mode.advance(0.01 + 1.3 * period);
  EXPECT_NEAR(mode.deflection(), before * std::exp(-damping * 2 * std::numbers::pi * 40 * period),
              1e-12);
}

TEST(vibration, is_the_same_however_time_is_cut) {
  plants::Vibration whole(25, 0.2);
  plants::Vibration cut(25, 0.2);
  whole.move_to(0, 3);
  cut.move_to(0, 3);
  for (int i = 1; i <= 100; ++i) cut.advance(i * 0.0003);
  whole.advance(0.03);
  EXPECT_NEAR(whole.deflection(), cut.deflection(), 1e-12);
  EXPECT_NEAR(whole.amplitude(), cut.amplitude(), 1e-12);
}

TEST(vibration, keeps_its_energy_without_damping) {
  plants::Vibration mode(60, 0);
  mode.move_to(0, 2);
  for (int i = 1; i < 50; ++i) {
    mode.advance(i * 0.0037);
    EXPECT_NEAR(mode.amplitude(), 2, 1e-9);
  }
}

TEST(vibration, lags_behind_a_steady_acceleration) {
  plants::Vibration mode(50, 0.7);
  const double acceleration = 1000;
  for (int i = 1; i < 20000; ++i) {
    const double time = i * 1e-5;
    mode.move_to(time, acceleration / 2 * time * time);
  }
  const double angular = 2 * std::numbers::pi * 50;
  // The damper pulls by the difference of speeds, which is 0.
  EXPECT_NEAR(mode.deflection(), -acceleration / (angular * angular), 2e-3);
}

}  // namespace
}  // namespace plants_test
