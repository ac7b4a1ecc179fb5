// SPDX-License-Identifier: Apache-2.0
// Pauses of a heat-up: when they come and how often, the drifts that they show, and that no
// described heater alarms in them.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/thermal/coasting_heater.hpp"

namespace {

using tests::CoastingHeater;
using tests::room;
using thermal::Coast;

struct Coasting : testing::Test, CoastingHeater {};

struct CoastingBed : testing::Test, CoastingHeater {
  CoastingBed() : CoastingHeater(machine::machine.bed.model) { target = 100; }
};

TEST_F(CoastingBed, a_slow_heater_never_pauses) {
  drift = 0.1;
  EXPECT_FALSE(run(600));
  EXPECT_EQ(pauses, 0);
}

TEST_F(Coasting, a_heater_as_described_pauses_once_half_way) {
  EXPECT_FALSE(heat_up_to(90));
  EXPECT_EQ(pauses, 0);
  EXPECT_FALSE(heat_up_to(200));
  EXPECT_EQ(pauses, 1);
  EXPECT_LT(longest, 10);
}

// So strong that it could hide a drift, or so weak that it may have one.
TEST_F(Coasting, a_weak_heater_pauses_in_the_cold_too) {
  power = 0.7;
  EXPECT_FALSE(heat_up_to(60));
  EXPECT_EQ(pauses, 1);
}

TEST_F(Coasting, a_hot_start_pauses_at_once) {
  block = reading = 150;
  EXPECT_FALSE(run(0.1));
  EXPECT_EQ(pauses, 1);
}

TEST_F(Coasting, no_pause_begins_near_the_target) {
  power = 0.7;
  for (target = 32; target < 200; target += 3) {
    coast.forget();
    EXPECT_FALSE(run(60, [] {}, [this] { return coast.is_pausing() || reading >= target - 10; }));
    pauses = 0;
    if (coast.is_pausing()) continue;
    EXPECT_FALSE(run(60));
    EXPECT_EQ(pauses, 0) << target;
  }
}

TEST_F(Coasting, no_pause_begins_while_a_target_is_held) {
  power = 0.7;
  held = true;
  EXPECT_FALSE(run(60));
  EXPECT_EQ(pauses, 0);
}

TEST_F(Coasting, finds_a_drift_that_begins_with_the_heat) {
  drift = 1;
  EXPECT_TRUE(run(20));
}

TEST_F(Coasting, finds_a_drift_that_begins_at_any_moment_far_below_the_target) {
  for (int begin = 1; begin < 75; ++begin) {
    CoastingHeater heater;
    ASSERT_FALSE(heater.run(begin)) << begin;
    if (heater.reading > heater.target - 40) break;
    heater.drift = 1;
    EXPECT_TRUE(heater.run(20)) << "begun after " << begin << " s";
  }
}

// So near to the target that only a doubt makes it pause.
TEST_F(Coasting, finds_a_drift_that_begins_just_below_the_target) {
  for (const double below : {9, 12, 15, 20}) {
    CoastingHeater heater;
    ASSERT_FALSE(heater.heat_up_to(heater.target - below)) << below;
    heater.drift = 1;
    EXPECT_TRUE(heater.run(20)) << below << " K below";
  }
}

// What is lost in the first pause shows more than the description.
TEST_F(Coasting, a_drift_shows_by_what_this_heater_has_lost_before) {
  loss = 0.6;
  EXPECT_FALSE(heat_up_to(185));
  drift = 0.8;
  EXPECT_TRUE(run(25));
}

TEST_F(Coasting, what_one_heater_has_lost_does_not_count_for_another) {
  loss = 0.5;
  EXPECT_FALSE(heat_up_to(140));
  wanted = false;
  run(1);
  wanted = true;
  loss = 1.6;
  draught = 0.3;
  coast.forget();
  EXPECT_FALSE(run(60));
}

// The firmware has just started, and knows nothing of the heat that is on its way.
TEST_F(Coasting, heat_from_before_a_start_does_not_count_as_little_loss) {
  block = reading = 150;
  late = 2.5;
  EXPECT_FALSE(run(100, [this] {
    draught = now > 20 ? 0.3 : 0;
    supply = now > 20 ? 0.7 : 1;
  }));
  EXPECT_GT(pauses, 1);
}
TEST_F(Coasting, no_heater_loses_less_than_described) {
  block = reading = 150;
  loss = 0.5;
  late = 0.8;
  late_seconds = 10;
  EXPECT_FALSE(run(100, [this] { supply = now > 20 ? 0.7 : 1; }));
  EXPECT_GT(pauses, 1);
}

// In a heater that loses as much as any, a window is wrong by nearly all of the noise.
bool alarms_by_a_wrong_window(double noise) {
  CoastingHeater heater;
  heater.loss = heater.model.most_loss / 100.0;
  heater.draught = heater.model.draught / 100.0;
  heater.block = heater.reading = 150;
  heater.noise = noise;
  bool was_wrong = false;
  return heater.run(12, [&] {
    if (was_wrong || heater.now < 5.2) return;
    was_wrong = true;
    heater.reading -= 1.1;
  });
}
TEST(coasting_in_noise, what_noise_may_hide_is_no_fault) {
  EXPECT_TRUE(alarms_by_a_wrong_window(0.1));
  EXPECT_FALSE(alarms_by_a_wrong_window(1.5));
}

TEST_F(Coasting, a_frozen_reading_does_not_answer) {
  power = 0.7;
  EXPECT_FALSE(run(6));
  frozen = true;
  EXPECT_TRUE(run(14));
}

// All within the tolerances, in draught that begins at any time while the supply falls.
TEST_F(Coasting, described_heaters_never_alarm) {
  std::mt19937 random(7);
  const auto between = [&random](double from, double to) {
    return from + (to - from) * static_cast<double>(random()) / 4294967296.0;
  };
  int paused = 0;
  for (int i = 0; i < 3'000; ++i) {
    CoastingHeater heater;
    heater.power = between(model.least_power, model.most_power) / 100;
    heater.loss = between(model.least_loss, model.most_loss) / 100;
    if (i % 2 == 0) heater.block = heater.reading = between(room, 150);
    heater.target = between(120, 250);
    const double begin = between(0, 120), end = begin + between(10, 60);
    const double falls = between(0.8, 1), blows = between(0, model.draught / 100.0);
    EXPECT_FALSE(heater.run(150,
                            [&] {
                              const bool windy = heater.now >= begin && heater.now < end;
                              heater.supply = windy ? falls : 1;
                              heater.draught = windy ? blows : 0;
                            }))
        << i << ", after " << heater.now << " s";
    paused += heater.pauses;
  }
  EXPECT_GT(paused, 3'000);
}

// A supply that falls again and again is suspicious: pauses come ever later.
TEST_F(Coasting, pauses_become_rare_where_they_find_nothing) {
  power = 0.8;
  loss = 1.5;
  target = 400;
  EXPECT_FALSE(run(1'000, [this] { supply = std::fmod(now, 40) < 30 ? 1 : 0.65; }));
  EXPECT_GE(pauses, 4);
  EXPECT_LT(pauses, 6 + 1'000 / 64);
  EXPECT_LE(longest, 12.05);
  EXPECT_EQ(sudden, 0);
}

TEST_F(Coasting, pauses_come_as_soon_as_at_first_after_a_target_was_held) {
  power = 0.8;
  loss = 1.5;
  target = 400;
  const auto flicker = [this] { supply = std::fmod(now, 40) < 30 ? 1 : 0.65; };
  EXPECT_FALSE(run(1'000, flicker));
  const int before = pauses;
  EXPECT_FALSE(run(200, flicker, [this, before] { return pauses > before; }));
  held = true;
  EXPECT_FALSE(run(15, flicker));
  held = false;
  EXPECT_FALSE(run(45, flicker));
  EXPECT_EQ(pauses, before + 2);
}

// Nothing is known while every conversion is faulty.
TEST_F(Coasting, a_pause_without_readings_ends) {
  const Coast::State hot{.celsius = 150'000, .below = 50'000, .full = true, .milliseconds = 100};
  for (int i = 0; i < 120; ++i) EXPECT_TRUE(coast.pause(hot)) << i;
  EXPECT_FALSE(coast.pause(hot));
}

// Full heat without a break for 8 s before each pause but one, whatever a host sets.
TEST_F(Coasting, targets_that_change_at_random_do_not_lead_to_pauses_without_end) {
  std::mt19937 random(3);
  for (int i = 0; i < 200; ++i) {
    CoastingHeater heater;
    heater.power = 0.7;
    if (i % 2 == 0) heater.block = heater.reading = 120;
    double next = 0;
    heater.run(600, [&] {
      heater.supply = std::fmod(heater.now, 20) < 10 ? 1 : 0.7;
      if (heater.now < next) return;
      next = heater.now + static_cast<double>(random() % 200) / 10;
      heater.wanted = random() % 3 != 0;
      heater.target = 50 + static_cast<double>(random() % 200);
      heater.held = random() % 8 == 0;
    });
    EXPECT_LE(heater.sudden, 1) << i;
    EXPECT_LE(heater.longest, 12.05) << i;
  }
}

}  // namespace
