// SPDX-License-Identifier: Apache-2.0
// Settings that must not change in motion are refused; there is no motion without a driver, and
// none without an end.
#include <limits>

#include "platform/bus.hpp"
#include "tests/drivers/step_generator_fixture.hpp"

namespace {

namespace registers = ::registers::step_generator;
using motion::Segment;
using units::Axis;

class StepGeneratorSettingsTest : public tests::StepGeneratorFixture {
 protected:
  static constexpr std::uint32_t settings_error = 1u << 5u, disabled_error = 1u << 6u;
  static constexpr std::uint32_t all_motors = 0b11111;

  // Since the last call.
  static std::uint32_t errors() {
    const std::uint32_t word = platform::read<registers::Errors>().encode();
    platform::write(registers::Command{.clear_errors = true});
    return word;
  }

  // A step of every axis, but for its commit.
  static void write_words() {
    platform::write(registers::SegmentFlags{});
    platform::write(registers::SegmentLineTicks{1});
    for (std::size_t axis = 0; axis < 5; ++axis) platform::write(axis, registers::SegmentSteps{1});
    platform::write(registers::SegmentTicks{1});
    platform::write(registers::SegmentRate{std::uint64_t{1} << 63u});
    platform::write(registers::SegmentAcceleration{});
    platform::write(registers::SegmentJerk{});
  }

  // X at the full rate, then `write`.
  template <class Write>
  void in_motion(Write write) {
    platform::write(registers::MotorEnable{.axes = all_motors});
    append(line({2000, 0, 0, 0}));
    chip_.clock(1000);
    ASSERT_TRUE(generator_.moving());
    write();
  }
};

TEST_F(StepGeneratorSettingsTest, refuses_another_guard_in_motion) {
  in_motion([] {
    platform::write(0, registers::PulseGuard{.high = 100, .low = 100});
    platform::write(0, registers::DirectionGuard{.setup = 100, .hold = 100});
  });
  EXPECT_EQ(errors(), settings_error);
  run_until_idle();
  EXPECT_EQ(pulses_.axis(0).longest_period, 2);
  EXPECT_EQ(generator_.counters().stall_clocks, 0);
  platform::write(0, registers::PulseGuard{.high = 3, .low = 3});
  EXPECT_EQ(errors(), 0);
}

TEST_F(StepGeneratorSettingsTest, refuses_another_rate_floor_in_motion) {
  in_motion([] { platform::write(registers::RateFloor{12345}); });
  EXPECT_EQ(errors(), settings_error);
  EXPECT_EQ(platform::read<registers::RateFloor>().rate, no_floor);
}

TEST_F(StepGeneratorSettingsTest, refuses_a_rate_floor_of_0) {
  platform::write(registers::RateFloor{0});
  EXPECT_EQ(errors(), settings_error);
  EXPECT_EQ(platform::read<registers::RateFloor>().rate, no_floor);
}

TEST_F(StepGeneratorSettingsTest, changes_no_kind_of_edge_while_the_pin_is_high) {
  platform::write(registers::MotorEnable{.axes = all_motors});
  platform::write(0, registers::PulseGuard{.high = 1, .low = 1, .both_edges = true});
  append(line({3, 0, 0, 0}));
  run_until_idle();
  EXPECT_EQ(chip_->step & 1u, 1u);
  platform::write(0, registers::PulseGuard{.high = 1, .low = 1});
  chip_.clock(10);
  EXPECT_EQ(errors(), settings_error);
  EXPECT_EQ(chip_->step & 1u, 1u);
  append(line({1, 0, 0, 0}));
  run_until_idle();
  EXPECT_EQ(chip_->step & 1u, 0u);
  platform::write(0, registers::PulseGuard{.high = 1, .low = 1});
  EXPECT_EQ(errors(), 0);
}

TEST_F(StepGeneratorSettingsTest, counts_no_step_of_a_motor_that_is_off) {
  platform::write(registers::MotorEnable{.axes = 0b11110});
  EXPECT_FALSE(generator_.append(line({10, 10, 0, 0})));
  append(line({0, 10, 0, 0}));
  run_until_idle();
  EXPECT_EQ(generator_.snapshot().positions[0], 0);
  EXPECT_EQ(generator_.snapshot().positions[1], 10);

  // Nor of a line that goes on.
  platform::write(registers::MotorEnable{.axes = all_motors});
  Segment part = line({10, 0, 0, 0});
  part.ticks = 5;
  append(part);
  run_until_idle();
  platform::write(registers::MotorEnable{.axes = 0b11110});
  part.continues_line = true;
  EXPECT_FALSE(generator_.append(part));
  platform::write(registers::MotorEnable{.axes = all_motors});
  append(part);
  run_until_idle();
  EXPECT_EQ(generator_.snapshot().positions[0], 10);
}

TEST_F(StepGeneratorSettingsTest, says_that_a_motor_is_off) {
  platform::write(registers::MotorEnable{.axes = 0b11110});
  write_words();
  platform::write(registers::SegmentCommit{});
  EXPECT_EQ(errors(), disabled_error);
}

TEST_F(StepGeneratorSettingsTest, keeps_its_motors_on_in_motion) {
  in_motion([] { platform::write(registers::MotorEnable{.axes = 0b11110}); });
  EXPECT_EQ(errors(), settings_error);
  EXPECT_EQ(chip_->enable, all_motors);
  run_until_idle();
  platform::write(registers::MotorEnable{.axes = 0b11110});
  EXPECT_EQ(errors(), 0);
  EXPECT_EQ(chip_->enable, 0b11110);
  // More motors may be on at any time.
  append(line({0, 1000, 0, 0}));
  platform::write(registers::MotorEnable{.axes = all_motors});
  EXPECT_EQ(errors(), 0);
  EXPECT_EQ(chip_->enable, all_motors);
  // And none after a stop, since no step begins then.
  generator_.stop();
  platform::write(registers::MotorEnable{.axes = 0});
  EXPECT_EQ(errors(), 0);
  EXPECT_EQ(chip_->enable, 0);
}

TEST_F(StepGeneratorSettingsTest, takes_the_motors_current_in_an_emergency) {
  in_motion([this] { chip_->emergency_stop = 1; });
  chip_.clock(1);
  EXPECT_EQ(chip_->enable, 0);
  platform::write(registers::MotorEnable{.axes = all_motors});
  EXPECT_EQ(chip_->enable, 0);
  chip_->emergency_stop = 0;
  chip_.clock(3);
  platform::write(registers::MotorEnable{.axes = all_motors});
  EXPECT_EQ(chip_->enable, 0);
  EXPECT_EQ(errors(), settings_error);
  generator_.acknowledge_stop();
  chip_.clock(3);
  EXPECT_EQ(chip_->enable, 0);
  platform::write(registers::MotorEnable{.axes = all_motors});
  EXPECT_EQ(chip_->enable, all_motors);
  EXPECT_EQ(errors(), 0);
  append(line({1, 0, 0, 0}));
}

TEST_F(StepGeneratorSettingsTest, takes_the_motors_current_also_after_a_stop_by_software) {
  platform::write(registers::MotorEnable{.axes = all_motors});
  generator_.stop();
  chip_.clock(100);
  chip_->emergency_stop = 1;
  chip_.clock(1);
  chip_->emergency_stop = 0;
  chip_.clock(1);
  EXPECT_EQ(chip_->enable, 0);
}

TEST_F(StepGeneratorSettingsTest, ends_a_segment_whatever_its_jerk) {
  for (const std::int64_t jerk :
       {std::int64_t{1} << 60, std::numeric_limits<std::int64_t>::max()}) {
    platform::write(registers::MotorEnable{.axes = all_motors});
    Segment segment = line({2000, 0, 0, 0}, rate(0.01));
    segment.jerk = jerk;
    append(segment);
    // It is at the highest rate after 2^21 clocks at most, and then makes a step every
    // second clock.
    chip_.clock(85000);
    EXPECT_FALSE(generator_.moving()) << jerk;
    generator_.stop();
    generator_.acknowledge_stop();
  }
}

TEST_F(StepGeneratorSettingsTest, answers_a_segment_that_is_committed_when_the_emergency_comes) {
  constexpr std::uint32_t while_stopped_error = 1u << 3u;
  int accepted = 0, refused = 0;
  std::uint64_t emergency = tests::PulseRecorder::never;
  chip_.after_clock = [&] { chip_->emergency_stop = chip_.now() >= emergency; };
  for (std::uint64_t delay = 0; delay < 8; ++delay) {
    emergency = tests::PulseRecorder::never;
    chip_->reset = 1;
    chip_.clock(2);
    chip_->reset = 0;
    use(shortest);
    generator_.permit_motion(false);
    platform::write(registers::MotorEnable{.axes = all_motors});
    write_words();
    chip_.clock(10);
    emergency = chip_.now() + delay - 3;
    platform::write(registers::SegmentCommit{});
    chip_.clock(20);
    EXPECT_TRUE(generator_.stop_state().emergency_input);
    EXPECT_EQ(generator_.queued_segments(), 0);
    // It was in the queue, and the stop discarded it; or it was refused.
    const std::uint32_t error = errors();
    const bool was_queued = generator_.counters().max_level == 1;
    EXPECT_EQ(error, was_queued ? 0 : while_stopped_error) << delay;
    (was_queued ? accepted : refused)++;
  }
  EXPECT_GT(accepted, 0);
  EXPECT_GT(refused, 0);
}

}  // namespace
