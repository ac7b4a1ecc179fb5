// SPDX-License-Identifier: Apache-2.0
// Software steps as the specification's model does: the same pins in the same order, at its times.
#include "software_stepping/stepper.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "tests/motion/step_model.hpp"
#include "tests/software_stepping/world.hpp"

namespace {

using motion::Segment;
using software_stepping::Counters;
using software_stepping::Guard;
using software_stepping::Stepper;
using software_stepping_test::make_world;
using software_stepping_test::world;

constexpr software_stepping::Interval longest = software_stepping::Interval{5'000'000} << 16;

constexpr double steepest = 0x1p-22;  // ticks per clock^2; the format ends at 2^-21

struct TickOf {
  double clock{};
  std::uint32_t pins{};
  std::uint32_t direction{};
};

// Lines in one to three parts, of all shapes; speeds between one tick in 300 and one in 30
// 000 clocks.
std::vector<Segment> random_segments(std::uint32_t seed, std::size_t lines) {
  std::mt19937 random(seed);
  const auto below = [&](std::uint32_t count) {
    return static_cast<std::uint32_t>(random() % count);
  };
  const auto rate = [&] { return std::exp2(-(8.3 + below(1000) * 0.0065)); };
  std::vector<Segment> segments;
  for (std::size_t i = 0; i < lines; ++i) {
    Segment line;
    line.line_ticks = 1 + below(below(4) == 0 ? 5 : 300);
    for (auto& steps : line.steps) {
      const auto size = static_cast<std::int32_t>(below(line.line_ticks + 1));
      steps = below(3) == 0 ? 0 : below(2) == 0 ? size : -size;
    }
    if (below(4) != 0) line.steps[below(4)] = static_cast<std::int32_t>(line.line_ticks);
    if (below(3) == 0) line.start.ahead.insert(units::Axis::x);
    if (below(3) == 0) line.start.behind.insert(units::Axis::y);
    double entry = rate();
    for (std::uint32_t done = 0; done < line.line_ticks;) {
      Segment part = line;
      part.continues_line = done != 0;
      part.ticks = std::min(line.line_ticks - done, 1 + below(line.line_ticks));
      done += part.ticks;
      // A ramp to a much lower rate in few ticks would depend on the rounding of its last clocks.
      const double exit = below(3) == 0 ? entry : std::clamp(rate(), entry / 2, entry * 2);
      part.rate = static_cast<std::uint64_t>(std::ldexp(entry, 64));
      const double acceleration = (exit * exit - entry * entry) / (2.0 * part.ticks);
      if (std::abs(acceleration) < steepest) {
        part.acceleration = static_cast<std::int64_t>(std::ldexp(acceleration, 84));
        entry = exit;
      }
      segments.push_back(part);
    }
  }
  segments.back().ends_motion = true;
  return segments;
}

std::vector<TickOf> ticks_of_model(const std::vector<Segment>& segments) {
  motion_test::StepModel model(segments.size());
  for (const Segment& segment : segments) model.push(segment);
  std::vector<TickOf> ticks;
  auto before = model.positions();
  std::uint32_t direction = 0;
  model.on_tick = [&](std::uint32_t, const Segment& segment) {
    TickOf tick{.clock = static_cast<double>(model.clocks())};
    for (std::size_t axis = 0; axis < units::axis_count; ++axis) {
      if (segment.steps[axis] != 0) {
        direction = segment.steps[axis] < 0 ? direction | 1u << axis : direction & ~(1u << axis);
      }
      if (model.positions()[axis] != before[axis]) tick.pins |= 1u << axis;
    }
    tick.direction = direction;
    before = model.positions();
    ticks.push_back(tick);
  };
  while (!model.idle()) model.clock();
  return ticks;
}

struct Motion {
  Counters counters;
  Stepper stepper{world().tick, counters};
  std::vector<TickOf> ticks;

  explicit Motion(const Guard& guard) {
    make_world();
    stepper.configure(guard, longest);
  }

  // Keeps the queue filled as the program does, and notes the pins of each tick.
  void execute(const std::vector<Segment>& segments) {
    std::size_t next = 0;
    while (next < segments.size() || stepper.moving()) {
      while (next < segments.size() && stepper.free() > 0) {
        ASSERT_TRUE(stepper.append(segments[next])) << next;
        ++next;
      }
      world().run(stepper, world().compare);
    }
    for (const auto& made : world().ticks) {
      ticks.push_back({static_cast<double>(made.clock), made.pins, made.direction});
    }
  }
};

void expect_same_ticks(const std::vector<TickOf>& actual, const std::vector<TickOf>& expected) {
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t i = 0; i < actual.size(); ++i) {
    ASSERT_EQ(actual[i].pins, expected[i].pins) << "tick " << i;
    // Without a step the direction's pin may wait.
    ASSERT_EQ(actual[i].direction, expected[i].direction) << "tick " << i;
  }
}

TEST(stepper, makes_the_steps_of_the_model_in_its_order) {
  for (std::uint32_t seed = 0; seed < 8; ++seed) {
    SCOPED_TRACE(seed);
    const auto segments = random_segments(seed, 60);
    Motion run({.high = 20, .low = 20, .direction_setup = 10, .direction_hold = 10});
    run.execute(segments);
    if (testing::Test::HasFatalFailure()) return;
    const auto expected = ticks_of_model(segments);
    expect_same_ticks(run.ticks, expected);
    EXPECT_EQ(run.stepper.counters().segments, segments.size());
    EXPECT_EQ(run.stepper.counters().underruns, 0u);
    EXPECT_EQ(run.stepper.counters().late_ticks, 0u);
    units::PerAxis<std::int64_t> positions{};
    for (const Segment& segment : segments) {
      if (segment.continues_line) continue;
      for (std::size_t axis = 0; axis < positions.size(); ++axis) {
        positions[axis] += segment.steps[axis];
      }
    }
    for (std::size_t axis = 0; axis < positions.size(); ++axis) {
      const auto& pulses = world().pulses.axis(axis);
      EXPECT_EQ(pulses.forward - pulses.backward, positions[axis]) << axis;
      EXPECT_EQ(run.stepper.positions()[axis], positions[axis]) << axis;
    }
  }
}

TEST(stepper, makes_them_at_the_models_times) {
  for (std::uint32_t seed = 100; seed < 104; ++seed) {
    SCOPED_TRACE(seed);
    const auto segments = random_segments(seed, 40);
    Motion run({.high = 20, .low = 20, .direction_setup = 10, .direction_hold = 10});
    run.execute(segments);
    const auto expected = ticks_of_model(segments);
    ASSERT_EQ(run.ticks.size(), expected.size());
    const double start = run.ticks.front().clock - expected.front().clock;
    for (std::size_t i = 1; i < expected.size(); ++i) {
      // A ramp in few ticks is cut into few steps of time; the model's into clocks.
      const double interval = expected[i].clock - expected[i - 1].clock;
      const double actual = run.ticks[i].clock - run.ticks[i - 1].clock;
      EXPECT_NEAR(actual, interval, 30 + 0.01 * interval) << "tick " << i;
    }
    const double time = expected.back().clock;
    EXPECT_NEAR(run.ticks.back().clock - start, time, 0.003 * time + 60);
  }
}

TEST(stepper, keeps_the_guard_whatever_is_asked) {
  for (const Guard& guard : {Guard{1, 1, 1, 1}, Guard{50, 50, 10, 10}, Guard{200, 700, 300, 250}}) {
    for (std::uint32_t seed = 0; seed < 4; ++seed) {
      auto segments = random_segments(seed, 60);
      // Faster than any guard or program permits.
      for (Segment& segment : segments) {
        segment.rate = std::min(segment.rate << 6, std::uint64_t{1} << 63);
      }
      Motion run(guard);
      run.execute(segments);
      for (std::size_t axis = 0; axis < units::axis_count; ++axis) {
        const auto& pulses = world().pulses.axis(axis);
        EXPECT_GE(pulses.shortest_high, guard.high);
        EXPECT_GE(pulses.shortest_low, guard.low);
        EXPECT_GE(pulses.shortest_setup, guard.direction_setup);
        EXPECT_GE(pulses.shortest_hold, guard.direction_hold);
      }
      const auto expected = ticks_of_model(segments);
      expect_same_ticks(run.ticks, expected);
      EXPECT_GT(run.stepper.counters().delay_clocks, 0u);
    }
  }
}

TEST(stepper, counts_ticks_that_it_cannot_make_in_time_and_makes_them_all) {
  Segment segment{.steps = {1000, 0, 0, 0}, .line_ticks = 1000, .ticks = 1000, .ends_motion = true};
  segment.rate = std::uint64_t{1} << 60;  // a tick every 16 clocks
  Motion run({1, 1, 1, 1});
  run.execute({segment});
  EXPECT_EQ(world().pulses.axis(0).forward, 1000);
  EXPECT_GT(run.stepper.counters().late_ticks, 900u);
  EXPECT_EQ(run.stepper.positions()[0], 1000);
}

TEST(stepper, steps_evenly_where_the_rate_is_constant) {
  Segment segment{.steps = {400, 133, -7, 0}, .line_ticks = 400, .ticks = 400, .ends_motion = true};
  segment.rate = ~std::uint64_t{0} / 1000;
  Motion run({1, 1, 1, 1});
  run.execute({segment});
  EXPECT_EQ(world().pulses.axis(0).shortest_period, 1000u);
  EXPECT_EQ(world().pulses.axis(0).longest_period, 1000u);
}

TEST(stepper, refuses_what_it_cannot_execute) {
  Motion run({1, 1, 1, 1});
  const Segment good{.steps = {5, 0, 0, 0}, .line_ticks = 5, .ticks = 5, .rate = 1u << 30};
  const auto refused = [&](auto change) {
    Segment segment = good;
    change(segment);
    return !run.stepper.append(segment);
  };
  EXPECT_TRUE(refused([](Segment& s) { s.ticks = 0; }));
  EXPECT_TRUE(refused([](Segment& s) { s.ticks = 6; }));
  EXPECT_TRUE(refused([](Segment& s) { s.steps[1] = -6; }));
  EXPECT_TRUE(refused([](Segment& s) { s.line_ticks = 0x80'0000; }));
  EXPECT_TRUE(refused([](Segment& s) { s.rate = (std::uint64_t{1} << 63) + 1; }));
  EXPECT_TRUE(refused([](Segment& s) { s.jerk = 1; }));
  EXPECT_TRUE(refused([](Segment& s) { s.stop_brakes = true; }));
  EXPECT_TRUE(refused([](Segment& s) { s.waits_for_start = true; }));
  EXPECT_TRUE(refused([](Segment& s) { s.continues_line = true; }));
  EXPECT_FALSE(run.stepper.moving());
  run.stepper.permit_motion(false);
  std::uint32_t taken = 0;
  while (run.stepper.append(good)) ++taken;
  EXPECT_EQ(taken, Stepper::queue_depth);
  EXPECT_FALSE(run.stepper.moving());
  run.stepper.permit_motion(true);
  EXPECT_TRUE(run.stepper.moving());
}

}  // namespace
