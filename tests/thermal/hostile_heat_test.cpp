// SPDX-License-Identifier: Apache-2.0
// Circumstances that look like faults, in which the heat goes on.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/thermal/rig.hpp"

namespace {

using tests::Part;
using tests::Rig;

constexpr double hotend_target = 205, bed_target = 60;

// What a script does, half an hour long, must neither end the heat nor unsettle it.
void expect_peace(const char* what, Part part, const tests::RigSettings& settings, double target,
                  const Rig::Script& script, double within = 3) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    tests::RigSettings seeded = settings;
    seeded.seed = seed;
    Rig rig(part, seeded);
    rig.set_target(target);
    rig.run(part == Part::bed ? 4'000 : 2'000, script);
    EXPECT_FALSE(rig.loop.fault())
        << what << ": " << thermal::name_of(*rig.loop.fault()) << " after " << rig.now << " s";
    EXPECT_TRUE(rig.loop.at_target()) << what;
    EXPECT_LT(rig.farthest, within) << what;
  }
}

// On for half of the period.
Rig::Script in_turn(double period, double Rig::* what, double on, double off) {
  return
      [=](Rig& rig, double time) { rig.*what = std::fmod(time, period) < period / 2 ? on : off; };
}

TEST(peace, bears_filament_in_any_rhythm) {
  for (const double period : {6.0, 8.2, 11.8, 12.0, 12.2, 17.0, 24.0}) {
    for (const double flow : {2.0, 4.0, 8.0}) {
      expect_peace("filament", Part::hotend, {}, hotend_target,
                   in_turn(period, &Rig::flow, flow, 0));
    }
  }
}

TEST(peace, bears_a_supply_that_sags_in_any_rhythm) {
  for (const double period : {6.0, 8.2, 12.2, 18.3, 30.5, 61.0}) {
    for (const Part part : {Part::hotend, Part::bed}) {
      expect_peace("sag", part, {}, part == Part::bed ? bed_target : hotend_target,
                   in_turn(period, &Rig::supply, 0.8, 1));
    }
  }
}

TEST(peace, bears_the_fan_in_any_rhythm) {
  for (const double period : {3.0, 12.0, 40.0, 60.0, 100.0}) {
    for (const Part part : {Part::hotend, Part::bed}) {
      expect_peace("fan", part, {}, part == Part::bed ? bed_target : hotend_target,
                   in_turn(period, &Rig::fan, 1, 0));
    }
  }
  expect_peace("fan at 240 degrees", Part::hotend, {}, 240,
               [](Rig& rig, double time) { rig.fan = time > 150 ? 1 : 0; });
}

// A hotend needs half as much heat again, for all that the firmware knows without a cause.
TEST(peace, bears_draught_that_begins_while_the_supply_falls) {
  const plants::HeatedBlockProperties hotend = tests::described_hotend();
  const double draught =
      0.3 * hotend.loss_watts_per_kelvin / hotend.fan_loss_watts_per_kelvin;  // as described
  for (const double begin : {20.0, 35.0, 52.0, 60.0, 66.0, 72.0, 120.0}) {
    for (const double start : {22.0, 205.0}) {
      expect_peace(
          "draught and sag", Part::hotend, {.start = start}, hotend_target,
          [begin, draught](Rig& rig, double time) {
            const bool windy = std::fmod(time, 2 * begin) > begin;
            rig.draught = windy ? draught : 0;
            rig.supply = windy ? 0.85 : 1;
          },
          4);
    }
  }
}

// A fan that cools more than described, and twice as much as its speed says.
TEST(peace, bears_a_fan_that_blows_more_than_it_says) {
  for (const double start : {22.0, 205.0}) {
    expect_peace(
        "fan", Part::hotend, {.start = start}, hotend_target,
        [](Rig& rig, double time) {
          const bool blows = std::fmod(time, 60) > 30;
          rig.fan = blows ? 0.5 : 0;
          rig.draught = blows ? 0.5 : 0;
        },
        4);
  }
}

TEST(peace, bears_heaters_and_rooms_of_all_kinds) {
  for (const Part part : {Part::hotend, Part::bed}) {
    const double target = part == Part::bed ? bed_target : hotend_target;
    const Rig::Script nothing = [](Rig&, double) {};
    expect_peace("cold room", part, {.room = 10, .start = 10}, target, nothing);
    expect_peace("enclosure", part, {.room = 50, .start = 50}, target, nothing);
    expect_peace("noise", part, {.noise = 0.12}, target, nothing);
    expect_peace("weak", part, {.power = 0.7}, target, nothing);
    expect_peace("strong", part, {.power = 1.3}, target, nothing);
    expect_peace("weaker half way", part, {}, target,
                 [](Rig& rig, double time) { rig.supply = time > 700 ? 0.7 : 1; });
    expect_peace("stronger half way", part, {.power = 1.3}, target,
                 [](Rig& rig, double time) { rig.supply = time > 700 ? 1 : 0.77; });
    expect_peace(
        "bursts of noise", part, {}, target,
        [](Rig& rig, double time) { rig.noise = std::fmod(time, 50) < 5 ? 1 : 0.03; }, 5);
  }
}

TEST(peace, bears_a_pair_of_wild_conversions) {
  for (const Part part : {Part::hotend, Part::bed}) {
    Rig rig(part, {.start = part == Part::bed ? 50.0 : 190.0});
    rig.hold(part == Part::bed ? bed_target : hotend_target, 60);
    rig.sense = [](double degrees, double time) {
      const double wild = std::fmod(time, 40) < 20 ? 30 : -30;
      return std::fmod(time, 20) < 0.15 ? degrees + wild : degrees;
    };
    rig.run(600);
    EXPECT_EQ(rig.loop.fault(), std::nullopt);
  }
}

TEST(peace, bears_targets_that_change) {
  for (const Part part : {Part::hotend, Part::bed}) {
    const double base = part == Part::bed ? bed_target : hotend_target;
    for (const auto& [step, every] : {std::pair{1.0, 6.0}, std::pair{2.0, 15.0},
                                      std::pair{5.0, 17.0}, std::pair{-30.0, 60.0}}) {
      Rig rig(part, {.start = part == Part::bed ? 50.0 : 190.0});
      rig.hold(base, 60);
      rig.run(2'000, [base, step, every](Rig& changed, double time) {
        changed.set_target(std::fmod(time, 2 * every) < every ? base : base + step);
      });
      EXPECT_EQ(rig.loop.fault(), std::nullopt) << step << " K every " << every << " s";
    }
  }
}

// A room is assumed at 25 degrees: a block that is hardly warmer says little of its losses.
TEST(peace, bears_cooling_to_a_low_target_in_a_cold_room) {
  for (const Part part : {Part::hotend, Part::bed}) {
    const double target = part == Part::bed ? bed_target : hotend_target;
    for (const double low : {24.0, 28.0, 35.0}) {
      Rig rig(part, {.room = 8, .start = target});
      rig.hold(target, 60);
      rig.set_target(low);
      rig.run(3'000);
      EXPECT_EQ(rig.loop.fault(), std::nullopt) << low << " after " << rig.now << " s";
      rig.hold(target, 60);
      EXPECT_EQ(rig.loop.fault(), std::nullopt) << low << " and back after " << rig.now << " s";
    }
  }
}

TEST(peace, bears_a_bed_that_gets_warmer_step_by_step_in_an_enclosure) {
  for (const double room : {38.0, 44.0}) {
    Rig rig(Part::bed, {.room = room, .start = room, .seed = 4});
    rig.hold(room + 2, 600);
    for (double target = room + 3; target < 75; ++target) rig.hold(target, 5);
    EXPECT_EQ(rig.loop.fault(), std::nullopt) << room << ", after " << rig.now << " s";
  }
}

// Once a minute, while it heats up: 8 K more than there are.
TEST(peace, bears_single_wild_conversions_while_it_heats_up) {
  for (const Part part : {Part::hotend, Part::bed}) {
    for (const double wild : {8.0, -30.0}) {
      Rig rig(part);
      rig.sense = [wild](double degrees, double time) {
        return std::fmod(time + 30, 60) < 0.05 ? degrees + wild : degrees;
      };
      rig.hold(part == Part::bed ? 95 : hotend_target, 60);
      EXPECT_EQ(rig.loop.fault(), std::nullopt) << wild << " K, after " << rig.now << " s";
    }
  }
}

TEST(peace, keeps_a_hotend_within_one_degree_of_its_target) {
  Rig rig(Part::hotend, {.start = 190});
  rig.hold(hotend_target, 30);
  rig.farthest = 0;
  rig.run(600);
  EXPECT_EQ(rig.loop.fault(), std::nullopt);
  EXPECT_LT(rig.farthest, 1.0);
}

// The probe's last half ends with the heat: what it would have brought must not shift the reading.
TEST(peace, comes_to_a_target_after_a_pause_at_any_moment_of_the_probe) {
  for (int i = 0; i < 18; ++i) {
    Rig rig(Part::hotend, {.start = 190, .seed = static_cast<std::uint64_t>(i + 1)});
    rig.hold(hotend_target, 30 + i);
    rig.set_target(0);
    rig.run(40);
    const double target = rig.block.celsius(rig.now) + 6;
    rig.set_target(target);
    rig.run(20);
    rig.highest = -300;
    rig.run(40);
    EXPECT_EQ(rig.loop.fault(), std::nullopt) << "after " << 30 + i << " s";
    EXPECT_NEAR(rig.block.celsius(rig.now), target, 1) << "after " << 30 + i << " s";
    EXPECT_LT(rig.highest, target + 1) << "after " << 30 + i << " s";
  }
}

// What is off may be warmed by others.
TEST(peace, bears_a_bed_that_an_enclosure_warms) {
  Rig rig(Part::bed, {.room = 40, .start = 22});
  rig.run(3'000);
  EXPECT_EQ(rig.loop.fault(), std::nullopt);
  EXPECT_GT(rig.block.celsius(rig.now), 39);
}

}  // namespace
