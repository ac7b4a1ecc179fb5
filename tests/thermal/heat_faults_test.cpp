// SPDX-License-Identifier: Apache-2.0
// A thermistor that freezes, drifts or falls out, and a heater that sticks: found in time, before
// the block is much hotter than wanted.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <vector>

#include "tests/thermal/rig.hpp"

namespace {

using plants::BeadFault;
using plants::HeaterFault;
using tests::bed_settings;
using tests::Bench;
using tests::Course;
using tests::hotend_settings;
using tests::Part;
using tests::Rig;

struct Find {
  double seconds = -1;  // from the fault to its finding; negative: never
  double highest = 0;  // true temperature of the block
};

// The fault comes when `is_time` says so, and has `patience` seconds to be found.
template <class IsTime, class Break>
Find find(Bench& bench, double target, double patience, IsTime is_time, Break break_it) {
  double broken_at = -1;
  Find result;
  const double begin = bench.now();
  const Course course = bench.run(target, 3'000, [&](double held) {
    if (broken_at < 0 && is_time(held, bench.now() - begin)) {
      broken_at = bench.now();
      break_it(bench.block, broken_at);
    }
    return broken_at < 0 || bench.now() - broken_at < patience;
  });
  result.highest = course.highest;
  if (broken_at >= 0 && course.fault) result.seconds = bench.now() - broken_at;
  return result;
}

const auto bead = [](BeadFault fault) {
  return [fault](plants::HeatedBlock& block, double now) { block.set_bead_fault(now, fault); };
};
const auto stick = [](plants::HeatedBlock& block, double now) {
  block.set_fault(now, HeaterFault::stuck_on);
};
const auto held_for = [](double seconds) {
  return [seconds](double held, double) { return held > seconds; };
};

void expect_found(const Find& found, double within, double below) {
  EXPECT_GE(found.seconds, 0) << "never found";
  EXPECT_LT(found.seconds, within);
  EXPECT_LT(found.highest, below);
  std::printf("found after %.1f s, block at most %.1f degrees\n", found.seconds, found.highest);
}

TEST(hotend_faults, finds_a_bead_that_freezes_while_it_heats_up) {
  // Near the target, where Marlin's protections take it for held.
  Bench bench(tests::described_hotend(), hotend_settings(), 8e6, 11);
  const auto near = [&bench](double, double) {
    return bench.block.sensor_celsius(bench.now()) > 202;
  };
  expect_found(find(bench, 205, 60, near, bead(BeadFault::frozen)), 20, 235);
}

TEST(hotend_faults, finds_a_bead_that_freezes_half_way) {
  Bench bench(tests::described_hotend(), hotend_settings(), 8e6, 12);
  const auto half_way = [](double, double seconds) { return seconds > 40; };
  expect_found(find(bench, 205, 60, half_way, bead(BeadFault::frozen)), 20, 235);
}

// The worst of all moments of the heat-up to 3 K below the target, from a cold and a warm start,
// however coarse the conversions are.
Find find_while_heating(const plants::HeatedBlockProperties& block,
                        const thermal::HeaterSettings& settings, double target, BeadFault fault,
                        int first_part = 0) {
  Find worst{.seconds = 0, .highest = -300};
  for (const double clock_hz : {4e6, 8e6, 50e6}) {
    for (const double start : {machine::ambient_celsius, target * 2 / 3}) {
      for (int part = first_part; part <= 10; ++part) {
        Bench bench(block, settings, clock_hz, 200 + static_cast<unsigned>(part), start);
        const double broken_at = start + (target - 3 - start) * part / 10;
        const auto is_hot = [&bench, broken_at](double, double) {
          return bench.block.sensor_celsius(bench.now()) >= broken_at;
        };
        const Find found = find(bench, target, 300, is_hot, bead(fault));
        EXPECT_GE(found.seconds, 0) << "never found, from " << start << ", at " << broken_at;
        worst.seconds = std::max(worst.seconds, found.seconds);
        worst.highest = std::max(worst.highest, found.highest);
      }
    }
  }
  return worst;
}

TEST(hotend_faults, finds_a_bead_that_freezes_at_any_moment_of_the_heat_up) {
  expect_found(
      find_while_heating(tests::described_hotend(), hotend_settings(), 205, BeadFault::frozen), 20,
      235);
}

TEST(bed_faults, finds_a_bead_that_freezes_at_any_moment_of_the_heat_up) {
  expect_found(find_while_heating(tests::described_bed(), bed_settings(), 60, BeadFault::frozen),
               20, 61);
}

TEST(hotend_faults, finds_a_bead_that_falls_out_at_any_moment_of_the_heat_up) {
  expect_found(
      find_while_heating(tests::described_hotend(), hotend_settings(), 205, BeadFault::detached),
      10, 210);
}

TEST(bed_faults, finds_a_bead_that_falls_out_at_any_moment_of_the_heat_up) {
  expect_found(find_while_heating(tests::described_bed(), bed_settings(), 60, BeadFault::detached),
               20, 61);
}

TEST(hotend_faults, finds_a_bead_that_drifts_from_any_moment_of_the_heat_up) {
  expect_found(
      find_while_heating(tests::described_hotend(), hotend_settings(), 205, BeadFault::drifting),
      20, 230);
}

TEST(hotend_faults, finds_a_bead_that_drifts_from_half_way_on) {
  expect_found(
      find_while_heating(tests::described_hotend(), hotend_settings(), 205, BeadFault::drifting, 5),
      20, 230);
}

TEST(bed_faults, finds_a_bead_that_drifts_from_any_moment_of_the_heat_up) {
  expect_found(find_while_heating(tests::described_bed(), bed_settings(), 60, BeadFault::drifting),
               10, 61);
}

// The reading runs ahead of the block.
TEST(bed_faults, finds_a_bead_that_drifts_upwards_while_it_heats_up) {
  for (const double broken_at : {22.0, 30.0, 45.0, 57.0}) {
    Rig rig(Part::bed);
    rig.set_target(60);
    rig.run(
        900, [](Rig&, double) {},
        [&rig, broken_at] { return rig.block.sensor_celsius(rig.now) >= broken_at; });
    ASSERT_EQ(rig.loop.fault(), std::nullopt);
    const double begun_at = rig.now;
    rig.drift(-1);
    rig.run(60);
    EXPECT_EQ(rig.loop.fault(), thermal::Fault::sensor_implausible) << "at " << broken_at;
    EXPECT_LT(rig.now - begun_at, 10) << "at " << broken_at;
  }
}

// Freezes at any moment of the probe. At 4 MHz the conversions are the noisiest: one of a hundred
// may take longer than 20 s.
void expect_frozen_found(const plants::HeatedBlockProperties& block,
                         const thermal::HeaterSettings& settings, double target, double below) {
  for (const double clock_hz : {4e6, 8e6, 50e6}) {
    std::vector<double> seconds;
    double highest = 0;
    const unsigned freezes = clock_hz > 4e6 ? 60 : 300;
    for (unsigned i = 0; i < freezes; ++i) {
      Bench bench(block, settings, clock_hz, 100 + i);
      const Find found = find(bench, target, 300, held_for(30 + 0.37 * i), bead(BeadFault::frozen));
      EXPECT_GE(found.seconds, 0) << "never found";
      seconds.push_back(found.seconds);
      highest = std::max(highest, found.highest);
    }
    std::ranges::sort(seconds);
    const auto late = std::ranges::count_if(seconds, [](double found) { return found > 20; });
    std::printf(
        "%.0f MHz: frozen at the target, %u found, %td later than 20 s; after %.1f s (half), "
        "%.1f s (all)\n",
        clock_hz / 1e6, freezes, late, seconds[freezes / 2], seconds.back());
    EXPECT_LE(late, clock_hz > 4e6 ? 0 : freezes / 100);
    EXPECT_LE(seconds.back(), clock_hz > 4e6 ? 20 : 23);
    EXPECT_LT(highest, below);
  }
}

TEST(hotend_faults, finds_a_bead_that_freezes_at_the_target) {
  expect_frozen_found(tests::described_hotend(), hotend_settings(), 205, 210);
}

TEST(hotend_faults, finds_a_bead_that_drifts) {
  Bench bench(tests::described_hotend(), hotend_settings(), 8e6, 13);
  expect_found(find(bench, 205, 60, held_for(20), bead(BeadFault::drifting)), 20, 235);
}

TEST(hotend_faults, finds_a_bead_that_has_fallen_out) {
  Bench bench(tests::described_hotend(), hotend_settings(), 8e6, 14);
  expect_found(find(bench, 205, 60, held_for(20), bead(BeadFault::detached)), 20, 235);
}

TEST(hotend_faults, finds_a_heater_that_sticks) {
  Bench bench(tests::described_hotend(), hotend_settings(), 8e6, 15);
  expect_found(find(bench, 205, 60, held_for(20), stick), 8, 235);
}

TEST(bed_faults, finds_a_heater_that_sticks) {
  Bench bench(tests::described_bed(), bed_settings(), 8e6, 16);
  expect_found(find(bench, 60, 600, held_for(60), stick), 20, 63);
}

TEST(bed_faults, finds_a_bead_that_freezes_while_it_heats_up) {
  Bench bench(tests::described_bed(), bed_settings(), 8e6, 17);
  const auto near = [&bench](double, double) {
    return bench.block.sensor_celsius(bench.now()) > 57;
  };
  expect_found(find(bench, 60, 600, near, bead(BeadFault::frozen)), 20, 63);
}

TEST(bed_faults, finds_a_bead_that_freezes_at_the_target) {
  expect_frozen_found(tests::described_bed(), bed_settings(), 60, 62);
}

TEST(bed_faults, finds_a_bead_that_drifts) {
  Bench bench(tests::described_bed(), bed_settings(), 8e6, 18);
  expect_found(find(bench, 60, 600, held_for(60), bead(BeadFault::drifting)), 20, 65);
}

TEST(bed_faults, finds_a_bead_that_has_fallen_out) {
  Bench bench(tests::described_bed(), bed_settings(), 8e6, 19);
  expect_found(find(bench, 60, 600, held_for(60), bead(BeadFault::detached)), 20, 65);
}

}  // namespace
