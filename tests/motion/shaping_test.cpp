// SPDX-License-Identifier: Apache-2.0
// Shaped motion against the exact convolution, and its totals against the planner's.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/motion/machine.hpp"
#include "tests/motion/shaping_run.hpp"

namespace motion_test {
namespace {

using motion::ShaperType;

motion::StepTiming timing_at(std::uint32_t clock_hz) {
  return timing(clock_hz, units::Microseconds(16'000'000'000 / clock_hz / 1000 + 1));
}

motion::ShapingSettings random_settings(std::mt19937& random, std::uint32_t clock_hz) {
  motion::ShapingSettings settings;
  const std::uint32_t least = clock_hz < 10'000'000 ? 15'000 : 26'000;
  const std::uint32_t most = clock_hz < 10'000'000 ? 38'000 : 80'000;
  for (motion::Shaper& shaper : settings.shapers) {
    shaper = {.type = static_cast<ShaperType>(random() % motion::shaper_type_count),
              .millihertz = least + static_cast<std::uint32_t>(random() % (most - least)),
              .damping = static_cast<std::uint32_t>(random() % 3000)};
  }
  if (random() % 3 != 0) {
    settings.advance_microseconds = static_cast<std::uint32_t>(random() % 200'000);
  }
  if (!settings.any()) settings.advance_microseconds = 50'000;
  return settings;
}

// Lines as of a print: short and long ones, printing, travel, retractions, lifts of Z.
std::vector<motion::LineMove> random_moves(std::mt19937& random, int count) {
  std::uniform_real_distribution<double> part(0, 1);
  std::vector<motion::LineMove> moves;
  std::array<std::int64_t, 4> place{};
  for (int i = 0; i < count; ++i) {
    const double length_nm = std::pow(10.0, 5 + 2.7 * part(random));
    const double angle = 6.2832 * part(random);
    const auto kind = random() % 10;
    if (kind == 0) {
      place[3] += static_cast<std::int64_t>((part(random) - 0.5) * 4e6);
    } else if (kind == 1) {
      place[2] += static_cast<std::int64_t>(part(random) * 3e5);
    } else {
      place[0] += static_cast<std::int64_t>(length_nm * std::cos(angle));
      place[1] += static_cast<std::int64_t>(length_nm * std::sin(angle));
      if (kind < 8) place[3] += static_cast<std::int64_t>(length_nm * 0.05 * part(random));
    }
    moves.push_back(
        {.target = at(place[0], place[1], place[2], place[3]),
         .feedrate = units::MicrometersPerSecond(5'000 + static_cast<int>(random() % 150'000))});
  }
  return moves;
}

units::PerAxis<std::int64_t> planned_steps(const motion::Limits& limits,
                                           const std::vector<motion::LineMove>& moves) {
  units::PerAxis<std::int64_t> steps;
  for (std::size_t i = 0; i < 4; ++i) {
    steps[i] = motion::steps_at(moves.back().target[i], limits.axes[i].steps_per_meter).steps;
  }
  return steps;
}

TEST(shaping, follows_the_exact_convolution_to_a_step) {
  std::mt19937 random(3);
  for (std::size_t round = 0; round < 60; ++round) {
    const std::uint32_t clock_hz = std::array{4'000'000u, 33'000'000u, 50'000'000u}[round % 3];
    const ShapingRunOptions options{.limits = mendel(),
                                    .timing = timing_at(clock_hz),
                                    .settings = random_settings(random, clock_hz)};
    const auto moves = random_moves(random, 120);
    const ShapingRunResult result = run_shaping(options, moves);
    // Rounding takes half a step, the rest is for jumps of speed between two samples, which are
    // 4 ms apart at 4 MHz.
    const double allowed = clock_hz < 8'000'000 ? 1.5 : 1.0;
    EXPECT_LE(result.worst_distance_steps, allowed) << round << " at " << clock_hz;
    EXPECT_EQ(result.steps, planned_steps(options.limits, moves));
    EXPECT_EQ(result.wrong_slots, 0u);
    EXPECT_EQ(result.wrong_ends, 0u);
    EXPECT_LE(result.worst_rate, 1.0);
    EXPECT_EQ(result.motions, 1u);
  }
}

TEST(shaping, ends_each_motion_at_the_planned_step) {
  std::mt19937 random(4);
  for (int round = 0; round < 40; ++round) {
    const std::uint32_t clock_hz = round % 2 == 0 ? 4'000'000 : 50'000'000;
    const ShapingRunOptions options{.limits = mendel(),
                                    .timing = timing_at(clock_hz),
                                    .settings = random_settings(random, clock_hz),
                                    .against_exact = false,
                                    .slots_per_move = static_cast<std::uint32_t>(random() % 300)};
    const auto moves = random_moves(random, 80);
    const ShapingRunResult result = run_shaping(options, moves);
    EXPECT_EQ(result.steps, planned_steps(options.limits, moves));
    EXPECT_EQ(result.wrong_slots, 0u);
    EXPECT_EQ(result.wrong_ends, 0u);
    EXPECT_LE(result.worst_rate, 1.0);
  }
}

// Moves of a step are shorter than a slot, and each begins when the one before has been played out.
TEST(shaping, makes_moves_that_are_shorter_than_a_slot) {
  motion::Planner planner(mendel(), timing_at(4'000'000));
  motion::Shaping shaping;
  shaping.set_timing(timing_at(4'000'000));
  shaping.set_limits(mendel());
  motion::ShapingSettings settings;
  settings.shapers[0] = {.type = ShaperType::mzv, .millihertz = 30'000, .damping = 1000};
  ASSERT_TRUE(shaping.configure(settings));
  units::Microseconds now;
  std::int64_t made = 0;
  for (std::int64_t step = 1; step <= 20; ++step) {
    ASSERT_TRUE(planner.append(
        {.target = at(step * 12'500, 0, 0, 0), .feedrate = units::MicrometersPerSecond(10'000)},
        now));
    planner.flush();
    for (int calls = 0; calls < 1000 && !(planner.empty() && shaping.at_rest()); ++calls) {
      const auto output = shaping.next_segment(planner, now, false);
      if (output.segment) made += output.segment->steps[0];
      now += units::Microseconds(5'000);
    }
    EXPECT_EQ(made, step);
  }
}

// A line at 20 mm/s of filament, and back: E goes ahead by K times its speed.
TEST(shaping, leads_the_extruder_by_k_times_its_speed) {
  std::vector<motion::LineMove> moves{{.target = at(100'000'000, 0, 0, 10'000'000),
                                       .feedrate = units::MicrometersPerSecond(100'000)}};
  ShapingRunOptions options{.limits = mendel(),
                            .timing = timing_at(50'000'000),
                            .settings = {.advance_microseconds = 100'000}};
  const ShapingRunResult with = run_shaping(options, moves);
  EXPECT_LE(with.worst_distance_steps, 1.0);
  EXPECT_EQ(with.steps[3], 5000);
  EXPECT_EQ(with.turns, 1u);  // it comes back where the line brakes
  // Filament alone is drawn back as it is.
  moves = {{.target = at(0, 0, 0, -2'000'000), .feedrate = units::MicrometersPerSecond(40'000)}};
  const ShapingRunResult retracted = run_shaping(options, moves);
  EXPECT_EQ(retracted.turns, 0u);
  EXPECT_EQ(retracted.steps[3], -1000);
}

// Even a K beyond any use keeps E within its driver, and the total.
TEST(shaping, keeps_the_extruder_within_its_speed) {
  std::mt19937 random(5);
  ShapingRunOptions options{.limits = mendel(),
                            .timing = timing_at(50'000'000),
                            .settings = {.advance_microseconds = 10'000'000},
                            .against_exact = false};
  options.timing.max_step_rate[3] = units::Hertz(45'000);
  const auto moves = random_moves(random, 60);
  const ShapingRunResult result = run_shaping(options, moves);
  EXPECT_LE(result.worst_rate, 1.0);
  EXPECT_GT(result.worst_rate, 0.85);  // M203 E is 80 mm/s, 40 000 steps/s
  EXPECT_LE(result.worst_rate, 0.91);
  EXPECT_EQ(result.steps, planned_steps(options.limits, moves));
}

TEST(shaping, lasts_longer_by_the_length_of_the_shaper) {
  const std::vector<motion::LineMove> moves{{.target = at(50'000'000, 50'000'000, 0, 0),
                                             .feedrate = units::MicrometersPerSecond(100'000)}};
  for (const auto type : {ShaperType::zv, ShaperType::zvd, ShaperType::mzv, ShaperType::ei,
                          ShaperType::two_hump_ei}) {
    const motion::Shaper shaper{.type = type, .millihertz = 40'000};
    const ShapingRunOptions options{.limits = mendel(),
                                    .timing = timing_at(50'000'000),
                                    .settings = {.shapers = {shaper, shaper}}};
    const ShapingRunResult result = run_shaping(options, moves);
    const motion::Impulses impulses = motion::impulses_of(shaper, options.timing.clock);
    const double longer = result.seconds - result.planned_seconds;
    const double length = impulses.list[impulses.count - 1].delay / 50e6;
    EXPECT_GE(longer, length);
    EXPECT_LE(longer, length + 6 * 65536 / 50e6);
  }
}

TEST(shaping, refuses_a_mode_that_its_slots_cannot_hold) {
  motion::Shaping shaping;
  shaping.set_timing(timing_at(50'000'000));
  const auto accepts = [&shaping](ShaperType type, std::uint32_t millihertz) {
    return shaping.configure({.shapers = {motion::Shaper{.type = type, .millihertz = millihertz}}});
  };
  EXPECT_TRUE(accepts(ShaperType::zv, 127'000));
  EXPECT_FALSE(accepts(ShaperType::zv, 128'000));
  EXPECT_EQ(shaping.settings().shapers[0].millihertz, 127'000u);
  EXPECT_TRUE(accepts(ShaperType::two_hump_ei, 10'000));
  EXPECT_FALSE(accepts(ShaperType::two_hump_ei, 5'000));
  EXPECT_EQ(shaping.slot_clocks(), 1u << 17);  // longer ones for it
  EXPECT_TRUE(accepts(ShaperType::zv, 40'000));
  EXPECT_EQ(shaping.slot_clocks(), 1u << 16);
  EXPECT_TRUE(shaping.active());
  EXPECT_TRUE(accepts(ShaperType::none, 0));
  EXPECT_FALSE(shaping.active());
}

}  // namespace
}  // namespace motion_test
