// SPDX-License-Identifier: Apache-2.0
// Every heater within the tolerances of the machine description, with a fault: how soon it is
// found, and how hot the block gets meanwhile.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "tests/thermal/rig.hpp"

namespace {

using tests::Part;
using tests::Rig;
using thermal::Fault;

constexpr double hotend_target = 205, bed_target = 60;

struct Found {
  int held = 0, found = 0, named = 0;
  double latest = 0, highest = -300;
};

double between(std::int32_t least, std::int32_t most, int step) {
  return least * std::pow(static_cast<double>(most) / least, step / 8.0) / 100;
}

// `prepare` brings the heater to where it breaks, and says whether it works until then. `expected`
// is the name that the fault should have.
template <class Prepare, class Break>
Found break_all(Part part, double start, Fault expected, Prepare prepare, Break break_it) {
  const thermal::HeaterModel& model =
      part == Part::bed ? machine::machine.bed.model : machine::machine.hotend.model;
  Found found;
  for (int power = 0; power < 9; ++power) {
    for (int loss = 0; loss < 9; ++loss) {
      Rig rig(part, {.power = between(model.least_power, model.most_power, power),
                     .loss = between(model.least_loss, model.most_loss, loss),
                     .start = start,
                     .seed = static_cast<std::uint64_t>(9 * power + loss)});
      if (!prepare(rig, power + loss) || rig.loop.fault()) {
        continue;  // too weak for this target
      }
      ++found.held;
      rig.highest = -300;
      const double broken_at = rig.now;
      break_it(rig);
      rig.run(900);
      found.found += rig.loop.fault() ? 1 : 0;
      found.named += rig.loop.fault() == expected ? 1 : 0;
      found.latest = std::max(found.latest, rig.now - broken_at);
      found.highest = std::max(found.highest, rig.highest);
    }
  }
  std::printf("%d of 81 heaters held, %d found, at most after %.1f s, block at most %.1f degrees\n",
              found.held, found.found, found.latest, found.highest);
  EXPECT_GT(found.held, 60);
  EXPECT_EQ(found.found, found.held);
  return found;
}

auto held(double target) {
  return [target](Rig& rig, int seconds) {
    rig.hold(target, 60 + seconds);
    return rig.loop.at_target();
  };
}

// A bead that freezes exactly at the target does no harm for as long as it is not found, in all
// heaters of the description that reach the target.
TEST(described_heaters, find_a_bead_that_freezes_at_the_target_and_stay_near_it) {
  const auto freeze_at = [](double target) {
    return [target](Rig& rig) { rig.sense = [target](double, double) { return target; }; };
  };
  const Found hotend = break_all(Part::hotend, hotend_target - 10, Fault::sensor_frozen,
                                 held(hotend_target), freeze_at(hotend_target));
  EXPECT_EQ(hotend.named, hotend.held);
  EXPECT_LT(hotend.latest, 20);
  EXPECT_LT(hotend.highest, hotend_target + 7);
  const Found bed = break_all(Part::bed, bed_target - 10, Fault::sensor_frozen, held(bed_target),
                              freeze_at(bed_target));
  EXPECT_EQ(bed.named, bed.held);
  EXPECT_LT(bed.latest, 26);
  EXPECT_LT(bed.highest, bed_target + 4);
}

// Brings the reading to `degrees` with all the heat on.
auto heated_up_to(double target, double degrees) {
  return [target, degrees](Rig& rig, int) {
    rig.set_target(target);
    const auto is_hot = [&rig, degrees] { return rig.block.sensor_celsius(rig.now) >= degrees; };
    rig.run(3'000, [](Rig&, double) {}, is_hot);
    return is_hot();
  };
}

TEST(described_heaters, find_a_bead_that_freezes_while_they_heat_up) {
  const auto freeze = [](Rig& rig) { rig.freeze(); };
  for (const double part : {0.1, 0.4, 0.7, 0.9}) {
    const auto broken_at = [part](double target) { return 22 + part * (target - 22); };
    const Found hotend = break_all(Part::hotend, 22, Fault::heating_failed,
                                   heated_up_to(hotend_target, broken_at(hotend_target)), freeze);
    EXPECT_LT(hotend.latest, 20) << "at " << broken_at(hotend_target);
    EXPECT_LT(hotend.highest, hotend_target + 20) << "at " << broken_at(hotend_target);
    const Found bed = break_all(Part::bed, 22, Fault::heating_failed,
                                heated_up_to(bed_target, broken_at(bed_target)), freeze);
    EXPECT_LT(bed.latest, 20) << "at " << broken_at(bed_target);
    EXPECT_LT(bed.highest, bed_target + 2) << "at " << broken_at(bed_target);
  }
}

// The firmware starts with the block at its target, and knows nothing of the heater.
TEST(described_heaters, find_a_bead_that_drifts_soon_after_a_warm_start) {
  for (const double seconds : {20, 30, 45, 60, 90}) {
    const auto begin = [seconds](Rig& rig, int) {
      rig.set_target(hotend_target);
      rig.run(seconds);
      return true;
    };
    const Found found = break_all(Part::hotend, hotend_target, Fault::thermal_runaway, begin,
                                  [](Rig& rig) { rig.drift(1); });
    EXPECT_LT(found.highest, 236) << "begun after " << seconds << " s";
  }
}

// A weak bed with much loss hardly gets warmer with all its heat than at its target: it takes
// minutes there, and does no harm.
TEST(described_heaters, find_a_bed_that_sticks_on_before_it_is_hot) {
  const Found bed = break_all(Part::bed, bed_target - 10, Fault::unasked_heat, held(bed_target),
                              [](Rig& rig) { rig.stuck_at = 1; });
  EXPECT_LT(bed.highest, bed_target + 4);
}

}  // namespace
