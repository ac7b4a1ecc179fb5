// SPDX-License-Identifier: Apache-2.0
// Heat-ups of random hotends, in which draught, fan, filament and a lower supply come and go: no
// false alarm in the pauses, and what they find.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "tests/thermal/random_plants.hpp"
#include "tests/thermal/rig.hpp"

namespace {

using plants::BeadFault;
using tests::Random;

// From `begin` for `seconds`.
struct Spell {
  double begin, seconds;
  bool lasts(double now) const { return now >= begin && now < begin + seconds; }
};

struct HeatUpEnd {
  std::optional<thermal::Fault> fault;
  double seconds = 0;  // after the bead broke
  double highest_above = -300;  // block above the target
  bool broke = false;  // while it was heating up
};

class HeatUp {
 public:
  explicit HeatUp(std::uint64_t seed)
      : random_(seed),
        properties_(tests::random_plant(kind_, random_)),
        room_(random_(15, 35)),
        start_(random_.chance(0.6) ? room_ : random_(room_, 150)),
        target_(std::min(random_(185, 250), reachable())),
        block_(properties_, room_, start_),
        loop_(kind_.settings),
        noise_(random_(0.01, 0.12)) {}

  // `breaks` says with each update, with the time and the duty of before, whether the bead breaks.
  template <class Breaks>
  HeatUpEnd run(BeadFault fault, Breaks breaks) {
    constexpr double seconds = 240;
    HeatUpEnd end;
    double broken_at = -1;
    loop_.set_target(tests::celsius(target_));
    std::uint32_t density = 0;
    for (double now = 0; now < seconds;) {
      disturb(now);
      const double below = target_ - block_.sensor_celsius(now);
      if (broken_at < 0 && below > 3 && breaks(now, loop_.duty(), below)) {
        broken_at = now;
        end.broke = true;
        block_.set_bead_fault(now, fault);
      }
      const double reading = block_.sensor_celsius(now) + noise_ * random_.normal();
      const double duty =
          loop_.update(tests::celsius(reading), units::Milliseconds(std::llround(now * 1000))) *
          (sag_.lasts(now) ? supply_ : 1);
      end.highest_above = std::max(end.highest_above, block_.celsius(now) - target_);
      end.seconds = now - broken_at;
      if ((end.fault = loop_.fault())) break;
      constexpr int slots = 4;
      for (int i = 0; i < slots; ++i) {
        density += static_cast<std::uint32_t>(duty);
        const bool on = density >= thermal::full_duty;
        if (on) density -= thermal::full_duty;
        block_.set_heater(now, on);
        now += tests::period / slots;
      }
    }
    return end;
  }

 private:
  double reachable() const {
    const double loss = properties_.loss_watts_per_kelvin * (1 + kind_.draught) +
                        properties_.fan_loss_watts_per_kelvin + 0.024;
    return room_ + 0.75 * properties_.heater_watts / loss;
  }
  Spell spell() { return {random_(0, 150), random_(20, 80)}; }
  void disturb(double now) {
    const double fan = fan_.lasts(now) ? speed_ : 0, flow = melt_.lasts(now) ? flow_ : 0;
    const double wind = draught_.lasts(now) ? kind_.draught * properties_.loss_watts_per_kelvin /
                                                  properties_.fan_loss_watts_per_kelvin
                                            : 0;
    block_.set_fan(now, fan + wind);
    block_.set_extrusion(now, flow);
    constexpr double filament_square_mm = 2.405;
    loop_.set_cooling({.fan = static_cast<std::uint8_t>(std::lround(fan * 255)),
                       .filament = units::MicrometersPerSecond(
                           static_cast<std::int32_t>(flow / filament_square_mm * 1000))});
  }

  tests::PlantKind kind_ = tests::hotend_kind();
  Random random_;
  plants::HeatedBlockProperties properties_;
  double room_, start_, target_;
  plants::HeatedBlock block_;
  thermal::HeaterLoop loop_;
  double noise_;
  Spell fan_ = spell(), melt_ = spell(), draught_ = spell();
  // Often at the same time as the draught.
  Spell sag_ = random_.chance(0.4) ? draught_ : spell();
  double speed_ = random_.chance(0.5) ? 1 : 0, flow_ = random_.chance(0.3) ? random_(0, 10) : 0;
  double supply_ = random_(0.9, 1);
};

TEST(heat_ups, give_no_false_alarm) {
  for (unsigned seed = 0; seed < 4'000; ++seed) {
    const HeatUpEnd end =
        HeatUp(seed).run(BeadFault::none, [](double, thermal::Duty, double) { return false; });
    EXPECT_FALSE(end.fault) << seed << ": " << thermal::name_of(*end.fault);
  }
}

struct Results {
  int broken = 0, found = 0, late = 0, hot = 0;  // later than 20 s, hotter than 30 K
};

template <class Breaks>
Results break_all(const char* what, BeadFault fault, Breaks breaks) {
  Results results;
  for (unsigned seed = 0; seed < 3'000; ++seed) {
    const HeatUpEnd end = HeatUp(seed).run(fault, breaks(seed));
    if (!end.broke) continue;
    ++results.broken;
    results.found += end.fault.has_value();
    results.late += !end.fault || end.seconds > 20;
    results.hot += end.highest_above > 30;
  }
  std::printf("%s: %d of %d found, %d later than 20 s, %d more than 30 K above the target\n", what,
              results.found, results.broken, results.late, results.hot);
  return results;
}

TEST(heat_ups, find_most_beads_that_drift_from_any_moment_on) {
  const Results results = break_all("drifting", BeadFault::drifting, [](unsigned seed) {
    return [moment = seed % 90](double now, thermal::Duty, double) { return now >= moment; };
  });
  EXPECT_GT(results.broken, 2'000);
  EXPECT_LT(results.late, results.broken * 4 / 100);
  EXPECT_LT(results.hot, results.broken * 2 / 1'000);
}

// Without heat a reading that stands still looks like a block that hardly cools down.
TEST(heat_ups, find_beads_that_freeze_in_a_pause) {
  const Results results = break_all("frozen in a pause", BeadFault::frozen, [](unsigned seed) {
    return [paused = 0U, moment = seed % 80](double now, thermal::Duty duty, double below) mutable {
      paused = duty == 0 && now > 1 && below > 10 ? paused + 1 : 0;
      return paused > moment;
    };
  });
  EXPECT_GT(results.broken, 1'000);
  EXPECT_LT(results.late, results.broken * 2 / 100);
  EXPECT_EQ(results.hot, 0);
}

// So near to the target a pause comes on suspicion only.
TEST(heat_ups, find_a_bead_of_the_described_hotend_that_drifts_near_the_target) {
  double latest = 0, highest = -300;
  for (double target = 180; target <= 260; target += 10) {
    for (double below = 25; below > 0; below -= 0.5) {
      tests::Rig rig(tests::Part::hotend, {.seed = 3});
      rig.set_target(target);
      rig.run(
          200, [](tests::Rig&, double) {},
          [&] { return rig.block.sensor_celsius(rig.now) >= target - below; });
      ASSERT_FALSE(rig.loop.fault());
      const double begun_at = rig.now;
      rig.drift(1);
      rig.run(200);
      EXPECT_TRUE(rig.loop.fault()) << target << ", " << below << " K below";
      latest = std::max(latest, rig.now - begun_at);
      highest = std::max(highest, rig.highest - target);
    }
  }
  std::printf("near the target: found after %.1f s, %.1f K above the target\n", latest, highest);
  EXPECT_LT(latest, 20);
  EXPECT_LT(highest, 15);
}

// What the pauses cost the hotend as described. Who waits for the target goes on waiting.
TEST(heat_ups, pause_the_described_hotend_for_less_than_ten_seconds) {
  for (const double start : {22, 137, 180}) {
    tests::Rig rig(tests::Part::hotend, {.start = start});
    rig.set_target(205);
    double paused = 0, arrived = 0;
    rig.run(200, [&](tests::Rig& at, double now) {
      if (arrived == 0 && at.loop.at_target() && now > 1) arrived = now;
      if (arrived > 0 || at.loop.duty() > 0 || at.block.celsius(now) > 195) return;
      paused += tests::period;
      EXPECT_FALSE(at.loop.at_target());
      EXPECT_TRUE(at.loop.temperature() || now == 0);
    });
    std::printf("from %.0f degrees: arrived after %.1f s, paused for %.1f s\n", start, arrived,
                paused);
    EXPECT_GT(arrived, 0);
    EXPECT_GT(paused, 5);
    EXPECT_LT(paused, 10);
  }
}

// With --warm a print starts so near to its target.
TEST(heat_ups, do_not_pause_near_the_target) {
  for (const double start : {196.0, 200.0, 202.0}) {
    tests::Rig rig(tests::Part::hotend, {.start = start});
    rig.set_target(205);
    rig.run(3, [](tests::Rig& at, double now) {
      if (now > 0) {
        EXPECT_GT(at.loop.duty(), 0) << now;
      }
    });
  }
}

}  // namespace
