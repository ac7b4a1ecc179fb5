// SPDX-License-Identifier: Apache-2.0
// The driver of the step generator against the Verilated hardware: steps, guards, joined lines.
#include <random>

#include "tests/drivers/step_generator_fixture.hpp"

namespace {

using drivers::GuardTimings;
using motion::Segment;
using testing::ElementsAre;
using units::Axis;

class StepGeneratorTest : public tests::StepGeneratorFixture {};

TEST_F(StepGeneratorTest, makes_exactly_the_steps_of_a_line) {
  append(line({100, -37, 0, 1}));
  run_until_idle();
  EXPECT_THAT(generator_.snapshot().positions, ElementsAre(100, -37, 0, 1));
  EXPECT_THAT(pulses_.counts(), ElementsAre(100, 37, 0, 1, 0));
}

TEST_F(StepGeneratorTest, steps_every_second_clock_on_every_axis_at_the_shortest_guard) {
  append(line({1000, 1000, 1000, 1000}));
  run_until_idle();
  EXPECT_THAT(pulses_.counts(), ElementsAre(1000, 1000, 1000, 1000, 0));
  for (std::size_t axis = 0; axis < 4; ++axis) {
    EXPECT_EQ(pulses_.axis(axis).shortest_period, 2);
    EXPECT_EQ(pulses_.axis(axis).longest_period, 2);
  }
  EXPECT_EQ(generator_.counters().stall_clocks, 0);
}

TEST_F(StepGeneratorTest, joins_segments_of_one_tick_at_full_rate_without_a_dead_clock) {
  generator_.permit_motion(false);
  for (int i = 0; i < 32; ++i) append(line({1, -1, 1, -1}));
  generator_.permit_motion(true);
  run_until_idle();
  EXPECT_THAT(pulses_.counts(), ElementsAre(32, 32, 32, 32, 0));
  EXPECT_EQ(pulses_.axis(0).longest_period, 2);
  EXPECT_EQ(generator_.counters().max_level, 32);
}

TEST_F(StepGeneratorTest, reverses_at_full_rate_without_a_dead_clock_at_the_shortest_guard) {
  generator_.permit_motion(false);
  for (int i = 0; i < 32; ++i) append(line({i % 2 == 0 ? 1 : -1, 1, 0, 0}));
  generator_.permit_motion(true);
  run_until_idle();
  EXPECT_EQ(pulses_.axis(0).longest_period, 2);
  EXPECT_EQ(generator_.counters().stall_clocks, 0);
  EXPECT_THAT(generator_.snapshot().positions, ElementsAre(0, 32, 0, 0));
}

TEST_F(StepGeneratorTest, delays_all_axes_rather_than_violate_the_guard_of_one) {
  const GuardTimings guard = GuardTimings::of(drivers::a4988, units::Hertz{50'000'000});
  use(guard);
  generator_.permit_motion(false);
  for (int i = 0; i < 10; ++i) append(line({i % 2 == 0 ? 7 : -7, 3, 0, 0}));
  generator_.permit_motion(true);
  run_until_idle();
  EXPECT_THAT(pulses_.counts(), ElementsAre(70, 30, 0, 0, 0));
  EXPECT_EQ(pulses_.axis(0).shortest_high, guard.high);
  EXPECT_GE(pulses_.axis(0).shortest_low, guard.low);
  EXPECT_GE(pulses_.axis(0).shortest_setup, guard.direction_setup);
  EXPECT_GE(pulses_.axis(0).shortest_hold, guard.direction_hold);
  EXPECT_GT(generator_.counters().axis_stall_clocks[0], 0);
  EXPECT_EQ(generator_.counters().axis_stall_clocks[2], 0);
}

TEST_F(StepGeneratorTest, keeps_a_line_straight_over_all_its_segments) {
  Segment part = line({90, 60, 30, 0}, half / 4);
  part.ends_motion = false;
  part.ticks = 13;
  append(part);
  part.continues_line = true;
  part.ticks = 31;
  part.rate = half / 3;
  append(part);
  part.ticks = 46;
  part.ends_motion = true;
  append(part);
  run_until_idle();
  EXPECT_THAT(generator_.snapshot().positions, ElementsAre(90, 60, 30, 0));
  EXPECT_EQ(generator_.counters().underruns, 0);
}

TEST_F(StepGeneratorTest, begins_a_line_a_quarter_of_a_step_early_or_late) {
  // The only step of an axis in 8 ticks comes at the fourth, early at the second, late
  // at the sixth.
  for (std::size_t axis = 0; axis < 4; ++axis) {
    for (const int shift : {0, 1, -1}) {
      Segment segment = line({0, 0, 0, 0}, rate(0.01));
      segment.line_ticks = 8;
      segment.steps.fill(1);
      segment.steps[(axis + 1) % 4] = 8;
      if (shift > 0) segment.start.ahead.insert(static_cast<Axis>(axis));
      if (shift < 0) segment.start.behind.insert(static_cast<Axis>(axis));
      segment.ticks = 1;
      segment.ends_motion = false;
      append(segment);
      segment.ticks = 7;
      segment.continues_line = true;
      segment.ends_motion = true;
      append(segment);
      const auto before = pulses_.counts();
      std::array<std::int64_t, 4> tick_of_step{};
      while (!generator_.idle()) {
        const auto counts = pulses_.counts();
        for (std::size_t i = 0; i < 4; ++i) {
          if (counts[i] > before[i] && tick_of_step[i] == 0) {
            tick_of_step[i] = counts[(axis + 1) % 4] - before[(axis + 1) % 4];
          }
        }
      }
      for (std::size_t i = 0; i < 4; ++i) {
        if (i == (axis + 1) % 4) continue;
        EXPECT_EQ(tick_of_step[i], i == axis ? 4 - 2 * shift : 4) << axis << ' ' << shift;
        EXPECT_EQ(pulses_.counts()[i], before[i] + 1);
      }
    }
  }
}

TEST_F(StepGeneratorTest, counts_an_underrun_only_where_motion_was_to_go_on) {
  Segment segment = line({5, 0, 0, 0});
  append(segment);
  run_until_idle();
  EXPECT_EQ(generator_.counters().underruns, 0);
  segment.ends_motion = false;
  append(segment);
  run_until_idle();
  EXPECT_EQ(generator_.counters().underruns, 1);
  EXPECT_EQ(generator_.snapshot().positions[0], 10);
}

TEST_F(StepGeneratorTest, never_comes_to_a_halt_below_the_rate_floor) {
  constexpr std::uint32_t floor = 1u << 22u;  // 2^-10 ticks per clock
  generator_.configure({shortest, shortest, shortest, shortest}, floor);
  Segment braking = line({100, 0, 0, 0}, rate(1.0 / 256));
  braking.acceleration = -(std::int64_t{1} << 62);  // at rest within 16384 clocks, 32 ticks
  append(braking);
  run_until_idle();
  EXPECT_EQ(generator_.snapshot().positions[0], 100);
  EXPECT_EQ(pulses_.axis(0).longest_period, 1024);
}

TEST_F(StepGeneratorTest, makes_the_steps_of_many_random_lines_exactly) {
  std::mt19937 random(1);
  std::array<std::int64_t, 4> expected{};
  for (int i = 0; i < 1000; ++i) {
    while (generator_.free_segments() == 0) chip_.clock(10);
    std::array<std::int32_t, 4> steps{};
    for (std::size_t axis = 0; axis < steps.size(); ++axis) {
      steps[axis] = static_cast<std::int32_t>(random() % 81) - 40;
      expected[axis] += steps[axis];
    }
    if (steps == decltype(steps){}) continue;
    append(line(steps, half >> (random() % 5u)));
  }
  run_until_idle();
  const auto positions = generator_.snapshot().positions;
  for (std::size_t axis = 0; axis < expected.size(); ++axis) {
    EXPECT_EQ(positions[axis], expected[axis]);
    EXPECT_EQ(pulses_.axis(axis).forward - pulses_.axis(axis).backward, expected[axis]);
  }
}

}  // namespace
