// SPDX-License-Identifier: Apache-2.0
// Heat-ups of a hotend that is hot already, about which little or nothing is known: it pauses at
// once, in noise and after a change of its sock too.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>

#include "tests/thermal/rig.hpp"

namespace {

using tests::Part;
using tests::Rig;

TEST(hot_starts, find_a_bead_that_freezes_at_any_moment) {
  double worst = 0;
  for (const double target : {150, 165, 180, 205, 230, 260}) {
    for (const double below : {12, 16, 20, 30, 45}) {
      for (int moment = 0; moment < 30; ++moment) {
        Rig rig(Part::hotend, {.start = target - below, .seed = 7});
        rig.set_target(target);
        rig.run(moment);
        ASSERT_FALSE(rig.loop.fault());
        const double begun_at = rig.now;
        rig.freeze();
        rig.run(100);
        ASSERT_TRUE(rig.loop.fault());
        worst = std::max(worst, rig.now - begun_at);
        EXPECT_LT(rig.now - begun_at, 20.15)
            << "from " << target - below << " to " << target << ", after " << moment << " s";
      }
    }
  }
  std::printf("frozen after a hot start: found after %.1f s at worst\n", worst);
}

// What is learnt in one pause is compared with in the next.
TEST(hot_starts, give_no_false_alarm_in_noise) {
  for (const double noise : {0.2, 0.3}) {
    for (double start = 85; start < 195; start += 5) {
      for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        Rig rig(Part::hotend, {.start = start, .noise = noise, .seed = seed});
        rig.set_target(240);
        rig.run(60);
        EXPECT_FALSE(rig.loop.fault()) << noise << " K, from " << start << ", seed " << seed;
      }
    }
  }
}

// The heater was off for so long that another sock may be mounted, or none.
TEST(hot_starts, give_no_false_alarm_after_the_sock_was_lost) {
  for (const double target : {200, 230}) {
    for (const double off_seconds : {125, 200, 400}) {
      for (std::uint64_t seed = 1; seed < 10; ++seed) {
        Rig rig(Part::hotend, {.loss = 0.5, .seed = seed});
        rig.set_target(target);
        rig.run(200);
        ASSERT_TRUE(rig.loop.at_target());
        rig.set_target(0);
        constexpr double without_sock = 2;  // of the described loss
        rig.draught = (without_sock - 0.5) * tests::described_hotend().loss_watts_per_kelvin /
                      tests::described_hotend().fan_loss_watts_per_kelvin;
        rig.run(off_seconds);
        rig.set_target(target - 20);
        rig.run(150);
        EXPECT_FALSE(rig.loop.fault()) << target << " degrees, off for " << off_seconds << " s";
      }
    }
  }
}

}  // namespace
