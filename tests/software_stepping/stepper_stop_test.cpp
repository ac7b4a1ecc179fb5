// SPDX-License-Identifier: Apache-2.0
// How software's motion ends: end stops, stops, empty queues; and what time means while it rests.
#include <gtest/gtest.h>

#include "software_stepping/stepper.hpp"
#include "tests/software_stepping/world.hpp"

namespace {

using motion::Segment;
using software_stepping::Counters;
using software_stepping::Stepper;
using software_stepping_test::make_world;
using software_stepping_test::world;

constexpr software_stepping::Interval longest = software_stepping::Interval{5'000'000} << 16;
constexpr std::uint64_t far_away = 1'000'000'000;

struct StepperStop : testing::Test {
  StepperStop() {
    make_world();
    stepper.configure({5, 5, 5, 5}, longest);
  }

  // One tick every `clocks`.
  static Segment line(std::int32_t steps, std::uint32_t clocks) {
    const auto ticks = static_cast<std::uint32_t>(steps < 0 ? -steps : steps);
    Segment segment{
        .steps = {steps, 0, 0, 0}, .line_ticks = ticks, .ticks = ticks, .ends_motion = true};
    segment.rate = ~std::uint64_t{0} / clocks;
    return segment;
  }
  std::int64_t pulses() const {
    return world().pulses.axis(0).forward - world().pulses.axis(0).backward;
  }

  Counters counters;
  Stepper stepper{world().tick, counters};
};

TEST_F(StepperStop, an_end_stop_ends_motion_before_the_next_step) {
  Segment homing = line(-1000, 2000);
  homing.stop_mask = 0b010;
  ASSERT_TRUE(stepper.append(homing));
  ASSERT_TRUE(stepper.append(line(500, 2000)));
  world().triggered = 0b101;
  world().run(stepper, 200 * 2000 + 1000);
  EXPECT_EQ(pulses(), -200);
  EXPECT_TRUE(stepper.moving());
  world().triggered = 0b111;
  world().run(stepper, far_away);
  EXPECT_EQ(pulses(), -200);
  EXPECT_TRUE(stepper.stopped());
  EXPECT_EQ(stepper.stop_cause(), 0b010);
  EXPECT_NEAR(static_cast<double>(stepper.stop_clock()), 201 * 2000, 200);
  EXPECT_EQ(stepper.positions()[0], -200);
  EXPECT_EQ(stepper.level(), 0u);
  EXPECT_FALSE(stepper.append(line(10, 2000)));
  stepper.acknowledge_stop();
  EXPECT_TRUE(stepper.append(line(10, 2000)));
  world().triggered = 0;
  world().run(stepper, 2 * far_away);
  EXPECT_EQ(pulses(), -190);
  EXPECT_EQ(stepper.positions()[0], -190);
}

TEST_F(StepperStop, an_end_stop_that_no_segment_asks_for_does_nothing) {
  world().triggered = 0xFF;
  ASSERT_TRUE(stepper.append(line(300, 1000)));
  world().run(stepper, far_away);
  EXPECT_EQ(pulses(), 300);
  EXPECT_FALSE(stepper.stopped());
}

TEST_F(StepperStop, the_programs_stop_leaves_true_positions) {
  Segment slanted = line(900, 1000);
  slanted.steps[1] = -431;
  ASSERT_TRUE(stepper.append(slanted));
  world().run(stepper, 333 * 1000 + 500);
  stepper.stop();
  world().run(stepper, far_away);
  EXPECT_EQ(pulses(), 333);
  EXPECT_EQ(stepper.positions()[0], 333);
  EXPECT_EQ(stepper.positions()[1], -world().pulses.axis(1).backward);
  EXPECT_EQ(stepper.stop_cause(), 0);
  EXPECT_TRUE(stepper.stopped());
}

TEST_F(StepperStop, positions_are_true_at_every_moment) {
  Segment slanted = line(50, 1000);
  slanted.steps = {-37, 50, 0, -1};
  slanted.start.ahead.insert(units::Axis::x);
  ASSERT_TRUE(stepper.append(slanted));
  for (std::uint64_t tick = 0; tick < 55; ++tick) {
    world().run(stepper, tick * 1000 + 500);
    for (std::size_t axis = 0; axis < units::axis_count; ++axis) {
      const auto& made = world().pulses.axis(axis);
      EXPECT_EQ(stepper.positions()[axis], made.forward - made.backward) << tick << " " << axis;
    }
  }
}

TEST_F(StepperStop, an_empty_queue_is_an_underrun_and_the_line_can_go_on) {
  Segment first = line(100, 1000);
  first.ticks = 40;
  first.ends_motion = false;
  ASSERT_TRUE(stepper.append(first));
  world().run(stepper, 100'000);
  EXPECT_EQ(counters.underruns, 1u);
  EXPECT_EQ(pulses(), 40);
  EXPECT_EQ(stepper.positions()[0], 40);
  Segment rest = first;
  rest.continues_line = true;
  rest.ends_motion = true;
  rest.ticks = 60;
  ASSERT_TRUE(stepper.append(rest));
  world().run(stepper, far_away);
  EXPECT_EQ(pulses(), 100);
  EXPECT_EQ(stepper.positions()[0], 100);
  EXPECT_EQ(counters.underruns, 1u);
}

TEST_F(StepperStop, a_flush_leaves_what_is_executed) {
  ASSERT_TRUE(stepper.append(line(100, 1000)));
  ASSERT_TRUE(stepper.append(line(100, 1000)));
  world().run(stepper, 10'500);
  stepper.flush();
  world().run(stepper, far_away);
  EXPECT_EQ(pulses(), 100);
  EXPECT_EQ(stepper.level(), 0u);
}

TEST_F(StepperStop, positions_are_set_only_at_rest) {
  ASSERT_TRUE(stepper.append(line(10, 1000)));
  EXPECT_FALSE(stepper.set_position(0, 7));
  world().run(stepper, far_away);
  EXPECT_TRUE(stepper.set_position(0, -7));
  EXPECT_EQ(stepper.positions()[0], -7);
}

TEST_F(StepperStop, the_alarm_rings_once_between_ticks_that_are_far_apart) {
  stepper.set_alarm(1500);
  EXPECT_EQ(world().compare, 1500u);
  ASSERT_TRUE(stepper.append(line(3, 100'000)));
  EXPECT_EQ(world().compare, 1500u);
  EXPECT_FALSE(stepper.alarm_has_passed());
  world().run(stepper, 50'000);
  EXPECT_TRUE(stepper.alarm_has_passed());
  EXPECT_EQ(pulses(), 0);
  EXPECT_NEAR(static_cast<double>(world().compare), 100'000, 200);
  world().run(stepper, far_away);
  EXPECT_EQ(pulses(), 3);
  EXPECT_EQ(world().compare, Stepper::never);
}

TEST_F(StepperStop, an_alarm_just_before_a_tick_makes_it_neither_late_nor_slower) {
  ASSERT_TRUE(stepper.append(line(40, 100'000)));
  for (std::uint64_t tick = 1; tick <= 40; ++tick) {
    stepper.set_alarm(tick * 100'000 - tick);
    world().run(stepper, tick * 100'000 + 50'000);
  }
  EXPECT_EQ(pulses(), 40);
  EXPECT_EQ(counters.late_ticks, 0u);
  EXPECT_EQ(counters.delay_clocks, 0u);
}

}  // namespace
