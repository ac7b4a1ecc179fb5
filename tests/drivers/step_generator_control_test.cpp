// SPDX-License-Identifier: Apache-2.0
// Software and switches during motion: stops, flushes, positions, motors.
#include "tests/drivers/step_generator_fixture.hpp"

namespace {

using motion::Segment;
using units::Axis;

class StepGeneratorControlTest : public tests::StepGeneratorFixture {};

TEST_F(StepGeneratorControlTest,
       stops_at_an_end_stop_and_keeps_position_and_time_until_acknowledged) {
  Segment segment = line({1000, 500, 0, 0}, rate(0.01));
  segment.stop_mask = 0b100;
  append(segment);
  append(line({1000, 0, 0, 0}));
  chip_->end_stops = 0b011;  // not requested
  chip_.clock(5000);
  EXPECT_FALSE(generator_.stop_state().stopped);
  chip_->end_stops = 0b111;
  const std::uint64_t hit = chip_.now();
  const auto pulses_at_hit = pulses_.counts();
  chip_.clock(1000);
  EXPECT_EQ(pulses_.counts(), pulses_at_hit);
  const auto stop = generator_.stop_state();
  EXPECT_TRUE(stop.stopped);
  EXPECT_EQ(stop.end_stops, 0b100);
  EXPECT_EQ(stop.clock, hit);
  EXPECT_EQ(stop.positions[0], pulses_at_hit[0]);
  EXPECT_EQ(stop.positions[1], pulses_at_hit[1]);
  EXPECT_EQ(generator_.queued_segments(), 0);
  EXPECT_FALSE(generator_.append(line({1, 0, 0, 0})));
  generator_.acknowledge_stop();
  append(line({1, 0, 0, 0}));
  run_until_idle();
  EXPECT_EQ(generator_.snapshot().positions[0], stop.positions[0] + 1);
}

TEST_F(StepGeneratorControlTest, stops_when_software_asks) {
  generator_.enable_stop_interrupt(true);
  append(line({1000, 0, 0, 0}, rate(0.02)));
  chip_.clock(3000);
  generator_.stop();
  const auto pulses_at_stop = pulses_.counts();
  chip_.clock(1000);
  EXPECT_EQ(pulses_.counts(), pulses_at_stop);
  EXPECT_TRUE(generator_.stop_state().software);
  EXPECT_TRUE(chip_->stop_interrupt);
  generator_.acknowledge_stop();
  chip_.clock(2);
  EXPECT_FALSE(chip_->stop_interrupt);
  EXPECT_FALSE(generator_.moving());
}

TEST_F(StepGeneratorControlTest, stays_stopped_while_the_emergency_stop_is_active) {
  chip_->emergency_stop = 1;
  chip_.clock(2);
  EXPECT_TRUE(generator_.stop_state().emergency_input);
  generator_.acknowledge_stop();
  EXPECT_TRUE(generator_.stop_state().stopped);
  chip_->emergency_stop = 0;
  EXPECT_TRUE(generator_.stop_state().stopped);
  generator_.acknowledge_stop();
  EXPECT_FALSE(generator_.stop_state().stopped);
}

TEST_F(StepGeneratorControlTest, takes_a_position_only_when_idle) {
  EXPECT_TRUE(generator_.set_position(Axis::z, -12345));
  append(line({0, 0, 1000, 0}, rate(0.01)));
  chip_.clock(1000);
  EXPECT_FALSE(generator_.set_position(Axis::z, 0));
  run_until_idle();
  EXPECT_EQ(generator_.snapshot().positions[2], -12345 + 1000);
}

TEST_F(StepGeneratorControlTest, takes_a_snapshot_of_one_instant) {
  append(line({1000, 1000, 1000, 1000}, rate(0.05)));
  chip_.clock(1234);
  const auto first = generator_.snapshot();
  EXPECT_GT(first.positions[0], 0);
  EXPECT_THAT(first.positions, testing::Each(first.positions[0]));
  const auto second = generator_.snapshot();
  EXPECT_GT(second.clock, first.clock);
  run_until_idle();
}

TEST_F(StepGeneratorControlTest, asks_for_more_at_the_threshold_of_the_queue) {
  generator_.permit_motion(false);
  generator_.enable_queue_interrupt(2);
  for (int i = 0; i < 2; ++i) append(line({1, 0, 0, 0}));
  EXPECT_TRUE(chip_->queue_interrupt);
  append(line({1, 0, 0, 0}));
  EXPECT_FALSE(chip_->queue_interrupt);
  generator_.permit_motion(true);
  run_until_idle();
  EXPECT_TRUE(chip_->queue_interrupt);
  generator_.disable_queue_interrupt();
  chip_.clock(2);
  EXPECT_FALSE(chip_->queue_interrupt);
}

TEST_F(StepGeneratorControlTest, forgets_the_queue_but_finishes_the_segment_when_flushed) {
  append(line({50, 0, 0, 0}, rate(0.01)));
  append(line({50, 0, 0, 0}));
  chip_.clock(100);
  generator_.flush();
  run_until_idle();
  EXPECT_EQ(generator_.snapshot().positions[0], 50);
}

TEST_F(StepGeneratorControlTest, enables_motors_one_by_one) {
  platform::write(registers::step_generator::MotorEnable{.axes = 0});
  generator_.enable_motor(Axis::y, true);
  generator_.enable_motor(Axis::e, true);
  EXPECT_EQ(chip_->enable, 0b1010);
  generator_.enable_motor(Axis::y, false);
  EXPECT_EQ(chip_->enable, 0b1000);
  EXPECT_TRUE(generator_.motor_enabled(Axis::e));
}

}  // namespace
