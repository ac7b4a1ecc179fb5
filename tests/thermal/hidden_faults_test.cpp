// SPDX-License-Identifier: Apache-2.0
// Faults that hide, found in time.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "tests/thermal/rig.hpp"

namespace {

using tests::Part;
using tests::Rig;

constexpr double hotend_target = 205, bed_target = 60;

// The worst of several moments at which the part breaks.
struct Worst {
  double seconds = 0;  // until found
  double highest = -300;  // of the block
  int missed = 0;
};

template <class Break>
Worst break_while_holding(Part part, double patience, Break break_it) {
  Worst worst;
  for (int i = 0; i < 8; ++i) {
    Rig rig(part,
            {.start = part == Part::bed ? 50.0 : 190.0, .seed = static_cast<std::uint64_t>(i + 1)});
    rig.hold(part == Part::bed ? bed_target : hotend_target, 90 + 7.3 * i);
    EXPECT_EQ(rig.loop.fault(), std::nullopt);
    const double broken_at = rig.now;
    break_it(rig);
    rig.run(patience);
    worst.missed += rig.loop.fault() ? 0 : 1;
    worst.seconds = std::max(worst.seconds, rig.now - broken_at);
    worst.highest = std::max(worst.highest, rig.highest);
  }
  std::printf("found after %.1f s at most, block at most %.1f degrees\n", worst.seconds,
              worst.highest);
  return worst;
}

void expect_found(const Worst& worst, double within, double below) {
  EXPECT_EQ(worst.missed, 0);
  EXPECT_LT(worst.seconds, within);
  EXPECT_LT(worst.highest, below);
}

TEST(hidden_faults, a_bead_that_freezes_at_the_target) {
  const auto freeze = [](Rig& rig) { rig.freeze(); };
  expect_found(break_while_holding(Part::hotend, 600, freeze), 20, 210);
  expect_found(break_while_holding(Part::bed, 900, freeze), 22, 62);
}

TEST(hidden_faults, a_bead_that_freezes_at_the_target_with_noise_on_it) {
  const auto freeze = [](Rig& rig) {
    rig.freeze();
    rig.noise = 0.1;
  };
  expect_found(break_while_holding(Part::hotend, 600, freeze), 35, 215);
  expect_found(break_while_holding(Part::bed, 900, freeze), 80, 62);
}

TEST(hidden_faults, a_bead_that_freezes_just_below_the_target_with_all_the_heat_on) {
  Rig rig(Part::hotend, {.start = 200});
  rig.set_target(hotend_target);
  rig.run(3);
  rig.sense = [](double, double) { return hotend_target - 3.5; };
  rig.run(600);
  EXPECT_NE(rig.loop.fault(), std::nullopt);
  EXPECT_LT(rig.highest, 270);
  std::printf("block at most %.1f degrees\n", rig.highest);
}

TEST(hidden_faults, a_bead_whose_reading_jumps) {
  for (const double kelvin : {10.0, 20.0, 60.0}) {
    const auto jump = [kelvin](Rig& rig) {
      rig.sense = [kelvin](double degrees, double) { return degrees - kelvin; };
    };
    expect_found(break_while_holding(Part::hotend, 300, jump), 5, 210);
    expect_found(break_while_holding(Part::bed, 600, jump), 5, 62);
  }
}

TEST(hidden_faults, a_bead_that_drifts_by_steps) {
  const auto steps = [](Rig& rig) {
    const double begin = rig.now;
    rig.sense = [begin](double degrees, double time) {
      return degrees - 10 * std::floor((time - begin) / 10);
    };
  };
  expect_found(break_while_holding(Part::hotend, 300, steps), 20, 220);
  expect_found(break_while_holding(Part::bed, 600, steps), 20, 63);
}

TEST(hidden_faults, a_bead_that_drifts) {
  const auto drift = [](Rig& rig) { rig.drift(1); };
  expect_found(break_while_holding(Part::hotend, 300, drift), 20, 225);
  expect_found(break_while_holding(Part::bed, 600, drift), 20, 62);
}

// Slow drifts are found late: firmware/thermal/faults.md.
TEST(hidden_faults, a_bead_that_drifts_slowly) {
  const auto slow = [](Rig& rig) { rig.drift(0.5); };
  expect_found(break_while_holding(Part::hotend, 300, slow), 80, 245);
  expect_found(break_while_holding(Part::bed, 600, slow), 20, 62);
  const auto slower = [](Rig& rig) { rig.drift(0.2); };
  expect_found(break_while_holding(Part::hotend, 900, slower), 450, 295);
  expect_found(break_while_holding(Part::bed, 600, slower), 40, 65);
}

TEST(hidden_faults, a_heater_that_sticks_on) {
  const auto stick = [](Rig& rig) { rig.stuck_at = 1; };
  expect_found(break_while_holding(Part::hotend, 300, stick), 10, 220);
  expect_found(break_while_holding(Part::bed, 600, stick), 26, 63.5);
}

TEST(hidden_faults, a_heater_that_sticks_half_on) {
  const auto stick = [](Rig& rig) { rig.stuck_at = 0.5; };
  expect_found(break_while_holding(Part::hotend, 300, stick), 20, 215);
  expect_found(break_while_holding(Part::bed, 600, stick), 120, 63.5);
}

TEST(hidden_faults, a_heater_that_breaks) {
  const auto open = [](Rig& rig) { rig.stuck_at = 0; };
  expect_found(break_while_holding(Part::hotend, 300, open), 20, 207);
  expect_found(break_while_holding(Part::bed, 600, open), 90, 61);
}

}  // namespace
