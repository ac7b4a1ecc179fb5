// SPDX-License-Identifier: Apache-2.0
// A hotend's reading that drifts away by 1 K/s, from any second between power-on and a minute of
// hold, after any start: found within 20 s, or the block stays within 30 K of its target.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>

#include "tests/thermal/random_plants.hpp"
#include "tests/thermal/rig.hpp"

namespace {

using tests::Part;
using tests::Random;
using tests::Rig;

constexpr double latest_seconds = 20, hottest_kelvin = 30;

// Drifts of each sweep; DRIFT_SWEEP in the environment chooses more, or fewer.
unsigned sweep_length() {
  const char* wanted = std::getenv("DRIFT_SWEEP");
  return wanted != nullptr ? static_cast<unsigned>(std::stoul(wanted)) : 300;
}

struct Case {
  double power = 1, loss = 1;  // of what is described
  double start = 22, target = 205, fan = 0;
  double begin = 0;  // of the drift: seconds after power-on
};

struct End {
  bool alarmed = false;  // before it drifts
  double seconds = 0;  // after it began
  double highest_above = -300;  // block above the target
};

End drift(const Case& given, unsigned seed) {
  Rig rig(Part::hotend,
          {.power = given.power, .loss = given.loss, .start = given.start, .seed = seed});
  rig.fan = given.fan;
  rig.set_target(given.target);
  rig.run(given.begin);
  End end;
  end.alarmed = rig.loop.fault().has_value();
  if (end.alarmed) return end;
  rig.highest = -300;
  rig.drift(1);
  rig.run(200);
  end.seconds = rig.now - given.begin;
  end.highest_above = rig.highest - given.target;
  return end;
}

// How long it heats up by the description.
double arrival(const Case& given) {
  Rig rig(Part::hotend, {.power = given.power, .loss = given.loss, .start = given.start});
  rig.fan = given.fan;
  rig.set_target(given.target);
  rig.run(600, [](Rig&, double) {}, [&rig] { return rig.loop.at_target(); });
  return rig.loop.at_target() ? rig.now : -1;
}

// With less than a quarter of its power left in the worst wind a heater may pass for a failing one.
bool holds(const Case& given) {
  const plants::HeatedBlockProperties hotend = tests::described_hotend();
  const double lost =
      hotend.loss_watts_per_kelvin * given.loss * 1.3 + hotend.fan_loss_watts_per_kelvin;
  return (given.target - 22) * lost < 0.75 * hotend.heater_watts * given.power;
}

struct Sweep {
  unsigned count = 0, late = 0, hot = 0;  // later than 20 s, hotter than 30 K
  double latest = 0, highest = -300;
};

// `begins`: the seconds between which a drift may begin, by the time of the arrival.
template <class Draw, class Begins>
Sweep sweep(const char* what, Draw draw, Begins begins) {
  Sweep result;
  for (unsigned seed = 0; result.count < sweep_length(); ++seed) {
    Random random(seed);
    Case given = draw(random);
    if (!holds(given)) continue;
    const double arrived = arrival(given);
    if (arrived < 0) continue;
    const auto [first, last] = begins(arrived);
    given.begin = std::floor(random(first, last));
    const End end = drift(given, seed);
    EXPECT_FALSE(end.alarmed) << what << ", seed " << seed;
    ++result.count;
    result.late += end.seconds > latest_seconds;
    result.hot += end.highest_above > hottest_kelvin;
    result.latest = std::max(result.latest, end.seconds);
    result.highest = std::max(result.highest, end.highest_above);
  }
  std::printf("%s: %u drifts, %u later than 20 s, %u hotter than 30 K; after %.1f s, %.1f K\n",
              what, result.count, result.late, result.hot, result.latest, result.highest);
  return result;
}

using Span = std::pair<double, double>;
const auto any_time = [](double arrived) { return Span{0, arrived + 60}; };
const auto once_held = [](double arrived) { return Span{arrived + 10, arrived + 60}; };

Case nominal(Random& random) {
  Case given;
  given.target = random(180, 260);
  given.start = 22 + (given.target - 22) * random(0, 1);
  const double fan = random(0, 3);
  given.fan = fan < 1 ? 0 : fan < 2 ? 0.5 : 1;
  return given;
}
Case cold(Random& random) {
  Case given = nominal(random);
  given.start = 22;
  return given;
}
Case hot(Random& random) {
  Case given = nominal(random);
  given.start = given.target - random(0, 30);
  return given;
}
template <class Draw>
auto described(Draw draw) {
  return [draw](Random& random) {
    Case given = draw(random);
    given.power = random(0.6, 1.3);
    given.loss = random(0.5, 1.6);
    return given;
  };
}

// Parts of all drifts, in thousandths.
void expect_at_most(const Sweep& result, unsigned late, unsigned hot) {
  EXPECT_LE(result.late * 1'000, late * result.count);
  EXPECT_LE(result.hot * 1'000, hot * result.count);
}

TEST(drifts, of_the_described_hotend_from_cold_are_found) {
  expect_at_most(sweep("cold", cold, any_time), 0, 0);
}

TEST(drifts, of_any_described_hotend_from_cold_are_found_or_do_little) {
  expect_at_most(sweep("cold, any heater", described(cold), any_time), 80, 10);
}

// In the first seconds after a start with a hot block nothing is known of the heater: faults.md.
TEST(drifts, of_the_described_hotend_from_anywhere_are_mostly_found) {
  expect_at_most(sweep("warm", nominal, any_time), 50, 20);
}

TEST(drifts, of_any_described_hotend_from_anywhere_are_mostly_found) {
  expect_at_most(sweep("warm, any heater", described(nominal), any_time), 100, 40);
}

TEST(drifts, of_the_described_hotend_from_hot_are_mostly_found) {
  expect_at_most(sweep("hot", hot, any_time), 140, 70);
}

TEST(drifts, of_any_described_hotend_from_hot_are_mostly_found) {
  expect_at_most(sweep("hot, any heater", described(hot), any_time), 180, 130);
}

TEST(drifts, of_the_described_hotend_in_a_hold_do_little) {
  expect_at_most(sweep("hot, held", hot, once_held), 200, 0);
}

}  // namespace
