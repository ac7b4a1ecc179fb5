// SPDX-License-Identifier: Apache-2.0
// Two extruders that share E: the one that is selected gets its steps, to the pulse, and the other
// one none.
#include <random>

#include "tests/drivers/step_generator_fixture.hpp"

namespace {

using drivers::GuardTimings;
using testing::ElementsAre;
using units::Axis;

class TwoExtruders : public tests::StepGeneratorFixture {};

TEST_F(TwoExtruders, get_the_steps_of_e_one_at_a_time) {
  append(line({100, 0, 0, 37}));
  run_until_idle();
  EXPECT_THAT(pulses_.counts(), ElementsAre(100, 0, 0, 37, 0));
  generator_.select_extruder(1);
  append(line({-10, 5, 0, -20}));
  run_until_idle();
  EXPECT_THAT(pulses_.counts(), ElementsAre(110, 5, 0, 37, 20));
  EXPECT_THAT(generator_.snapshot().positions, ElementsAre(90, 5, 0, -20));
  generator_.select_extruder(0);
  EXPECT_THAT(generator_.snapshot().positions, ElementsAre(90, 5, 0, 37));
}

// However the changes fall: as soon as the generator is idle, with no pause.
TEST_F(TwoExtruders, lose_no_pulse_at_a_change) {
  std::mt19937 random(7);
  std::array<std::int64_t, 5> pulses{};
  std::array<std::int32_t, 2> filament{};
  std::size_t extruder = 0;
  use(GuardTimings::of(drivers::a4988, units::Hertz{50'000'000}));
  generator_.configure_second_extruder(GuardTimings{3, 4, 1, 1});
  for (int i = 0; i < 200; ++i) {
    const auto steps = static_cast<std::int32_t>(random() % 41) - 20;
    const auto others = static_cast<std::int32_t>(random() % 30) + 1;
    append(line({others, 0, -others, steps}, half / (1 + random() % 4)));
    pulses[0] += others;
    pulses[2] += others;
    pulses[3 + extruder] += std::abs(steps);
    filament[extruder] += steps;
    if (random() % 3 != 0) continue;
    while (!generator_.idle()) chip_.clock(1);
    extruder = 1 - extruder;
    generator_.select_extruder(extruder);
    EXPECT_EQ(generator_.snapshot().positions[3], filament[extruder]) << i;
  }
  run_until_idle();
  EXPECT_THAT(pulses_.counts(), testing::ElementsAreArray(pulses));
}

TEST_F(TwoExtruders, keep_the_guard_of_their_own_driver) {
  const GuardTimings slow{40, 60, 20, 30};
  generator_.configure_second_extruder(slow);
  for (const std::size_t extruder : {0UZ, 1UZ}) {
    generator_.select_extruder(extruder);
    for (int i = 0; i < 10; ++i) append(line({0, 0, 0, i % 2 == 0 ? 5 : -5}));
    run_until_idle();
  }
  EXPECT_EQ(pulses_.axis(3).shortest_period, 2);
  EXPECT_EQ(pulses_.axis(4).shortest_high, slow.high);
  EXPECT_GE(pulses_.axis(4).shortest_low, slow.low);
  EXPECT_GE(pulses_.axis(4).shortest_setup, slow.direction_setup);
  EXPECT_GE(pulses_.axis(4).shortest_hold, slow.direction_hold);
}

TEST_F(TwoExtruders, have_a_motor_each) {
  platform::write(registers::step_generator::MotorEnable{.axes = 0});
  generator_.enable_motor(Axis::e, true);
  EXPECT_EQ(platform::read<registers::step_generator::MotorEnable>().axes, 0b01000u);
  generator_.select_extruder(1);
  EXPECT_FALSE(generator_.motor_enabled(Axis::e));
  EXPECT_FALSE(generator_.append(line({0, 0, 0, 5})));  // its motor is off
  generator_.enable_motor(Axis::e, true);
  EXPECT_EQ(platform::read<registers::step_generator::MotorEnable>().axes, 0b11000u);
  append(line({0, 0, 0, 5}));
  run_until_idle();
  generator_.enable_motor(Axis::e, false);
  EXPECT_EQ(platform::read<registers::step_generator::MotorEnable>().axes, 0b01000u);
}

TEST_F(TwoExtruders, have_a_position_each_that_is_set_alone) {
  EXPECT_TRUE(generator_.set_position(Axis::e, 1000));
  generator_.select_extruder(1);
  EXPECT_EQ(generator_.snapshot().positions[3], 0);
  EXPECT_TRUE(generator_.set_position(Axis::e, -5));
  append(line({0, 0, 0, 3}));
  run_until_idle();
  generator_.stop();
  EXPECT_EQ(generator_.stop_state().positions[3], -2);
  generator_.select_extruder(0);
  EXPECT_EQ(generator_.stop_state().positions[3], 1000);
}

// The only step of E in 8 ticks comes at the fourth, early at the second, late at the sixth. The
// second extruder's always comes in the middle.
TEST_F(TwoExtruders, start_lines_of_the_first_alone_early_and_late) {
  for (const std::size_t extruder : {0UZ, 1UZ}) {
    generator_.select_extruder(extruder);
    for (const int shift : {0, 1, -1}) {
      motion::Segment segment = line({8, 0, 0, 1}, rate(0.01));
      if (shift > 0) segment.start.ahead.insert(Axis::e);
      if (shift < 0) segment.start.behind.insert(Axis::e);
      const auto before = pulses_.counts();
      append(segment);
      std::int64_t tick = 0;
      while (!generator_.idle()) {
        const auto counts = pulses_.counts();
        if (tick == 0 && counts[3 + extruder] > before[3 + extruder]) tick = counts[0] - before[0];
      }
      EXPECT_EQ(tick, extruder == 0 ? 4 - 2 * shift : 4) << extruder;
    }
  }
}

}  // namespace
