// SPDX-License-Identifier: Apache-2.0
// Stops by edge and level, at once and along the brake's ramp; the watchdog; starts in common.
#include "platform/bus.hpp"
#include "tests/drivers/step_generator_fixture.hpp"

namespace {

using motion::Segment;
using testing::ElementsAre;

class StepGeneratorStopTest : public tests::StepGeneratorFixture {
 protected:
  // 2^32 / 2^20 = 4096 clocks to rest.
  static constexpr std::uint32_t slope = 1u << 20u;
  static constexpr int clocks_to_rest = 4096;

  // A long line that is under way, which these end stops end.
  void run(std::uint8_t stop_mask, bool stop_brakes) {
    generator_.set_slopes(slope, slope);
    Segment segment = line({20000, 0, 0, 0}, rate(0.05));
    segment.stop_mask = stop_mask;
    segment.stop_brakes = stop_brakes;
    append(segment);
    chip_.clock(5000);
  }

  void expect_end_stop_while_braking(std::uint8_t end_stops) {
    EXPECT_TRUE(generator_.stop_state().braking);
    chip_->end_stops = end_stops;
    const auto at_hit = pulses_.counts();
    chip_.clock(clocks_to_rest);
    EXPECT_EQ(pulses_.counts(), at_hit);
    EXPECT_TRUE(generator_.stop_state().stopped);
  }
};

TEST_F(StepGeneratorStopTest, brakes_along_the_path_and_keeps_the_position_of_the_hit) {
  generator_.set_slopes(slope, slope);
  generator_.enable_stop_interrupt(true);
  Segment segment = line({20000, 10000, 0, 0}, rate(0.01));
  segment.stop_mask = 0b100;
  segment.stop_brakes = true;
  append(segment);
  append(line({1000, 0, 0, 0}));
  chip_.clock(50000);
  chip_->end_stops = 0b100;
  const std::uint64_t hit = chip_.now();
  const auto at_hit = pulses_.counts();
  chip_.clock(10);
  auto stop = generator_.stop_state();
  EXPECT_TRUE(stop.braking);
  EXPECT_FALSE(stop.stopped);
  EXPECT_TRUE(generator_.moving());
  EXPECT_EQ(stop.end_stops, 0b100);
  EXPECT_EQ(stop.clock, hit);
  EXPECT_EQ(stop.positions[0], at_hit[0]);
  EXPECT_EQ(stop.positions[1], at_hit[1]);
  chip_->end_stops = 0;  // it bounces: no matter
  chip_.clock(clocks_to_rest);
  stop = generator_.stop_state();
  EXPECT_TRUE(stop.stopped);
  EXPECT_FALSE(stop.braking);
  EXPECT_TRUE(chip_->stop_interrupt);
  EXPECT_FALSE(generator_.moving());
  EXPECT_EQ(generator_.queued_segments(), 0);
  EXPECT_EQ(stop.positions[0], at_hit[0]);
  const auto at_rest = generator_.snapshot().positions;
  // Half of the clocks to rest at 0.01 ticks per clock.
  EXPECT_NEAR(at_rest[0] - stop.positions[0], 20, 1);
  EXPECT_EQ(at_rest[0], pulses_.counts()[0]);
  EXPECT_EQ(at_rest[1], pulses_.counts()[1]);
  EXPECT_NEAR(at_rest[1], at_rest[0] / 2, 1);
  generator_.acknowledge_stop();
  append(line({5, 0, 0, 0}));
  run_until_idle();
  EXPECT_EQ(generator_.snapshot().positions[0], at_rest[0] + 5);
}

TEST_F(StepGeneratorStopTest, brakes_on_through_the_segments_that_are_queued) {
  generator_.set_slopes(slope, slope);
  Segment part = line({3000, 0, 0, 0}, rate(0.01));
  part.stop_mask = 1;
  part.stop_brakes = true;
  part.ends_motion = false;
  part.ticks = 510;
  append(part);
  part.continues_line = true;
  part.ticks = 2490;
  append(part);
  chip_.clock(50500);
  chip_->end_stops = 1;
  chip_.clock(clocks_to_rest + 10);
  EXPECT_TRUE(generator_.stop_state().stopped);
  EXPECT_EQ(generator_.counters().segments, 2);
  EXPECT_NEAR(generator_.snapshot().positions[0] - generator_.stop_state().positions[0], 20, 1);
}

TEST_F(StepGeneratorStopTest, ends_braking_with_the_last_step_where_the_path_is_shorter) {
  generator_.set_slopes(slope, slope);
  append(line({1000, 0, 0, 0}, rate(0.01)));
  chip_.clock(99500);
  generator_.brake();
  chip_.clock(2000);
  EXPECT_TRUE(generator_.stop_state().stopped);
  EXPECT_TRUE(generator_.stop_state().software_brake);
  EXPECT_EQ(generator_.snapshot().positions[0], 1000);
}

TEST_F(StepGeneratorStopTest, stops_at_once_when_the_emergency_stop_comes_while_braking) {
  append(line({20000, 0, 0, 0}, rate(0.01)));
  chip_.clock(5000);
  generator_.brake();
  chip_.clock(500);
  EXPECT_TRUE(generator_.stop_state().braking);
  chip_->emergency_stop = 1;
  const auto at_stop = pulses_.counts();
  chip_.clock(5000);
  EXPECT_EQ(pulses_.counts(), at_stop);
  const auto stop = generator_.stop_state();
  EXPECT_TRUE(stop.stopped && stop.emergency_input && stop.software_brake);
  EXPECT_LT(stop.positions[0], at_stop[0]);
}

TEST_F(StepGeneratorStopTest, stops_at_once_at_another_end_stop_while_braking) {
  run(0b11, true);
  chip_->end_stops = 0b01;
  chip_.clock(500);
  expect_end_stop_while_braking(0b11);
  const auto stop = generator_.stop_state();
  EXPECT_EQ(stop.end_stops, 0b11);
  EXPECT_LT(stop.positions[0], pulses_.counts()[0]);
}

TEST_F(StepGeneratorStopTest, stops_at_once_where_the_switch_that_brakes_is_hit_again) {
  run(0b1, true);
  chip_->end_stops = 0b1;
  chip_.clock(500);
  chip_->end_stops = 0;
  chip_.clock(500);
  expect_end_stop_while_braking(0b1);
}

TEST_F(StepGeneratorStopTest, stops_at_an_end_stop_while_software_brakes) {
  run(0b100, false);
  generator_.brake();
  chip_.clock(500);
  expect_end_stop_while_braking(0b100);
  const auto stop = generator_.stop_state();
  EXPECT_TRUE(stop.software_brake);
  EXPECT_EQ(stop.end_stops, 0b100);
}

TEST_F(StepGeneratorStopTest, stops_at_once_where_the_brake_has_no_slope) {
  generator_.set_slopes(slope, 0);
  append(line({2000, 0, 0, 0}, rate(0.01)));
  chip_.clock(5000);
  generator_.brake();
  chip_.clock(3);
  const auto at_brake = pulses_.counts();
  chip_.clock(500000);
  EXPECT_EQ(pulses_.counts(), at_brake);
  EXPECT_TRUE(generator_.stop_state().stopped);

  // Taken away while it brakes.
  generator_.acknowledge_stop();
  generator_.set_slopes(slope, slope);
  append(line({2000, 0, 0, 0}, rate(0.01)));
  chip_.clock(5000);
  generator_.brake();
  chip_.clock(500);
  EXPECT_TRUE(generator_.stop_state().braking);
  generator_.set_slopes(slope, 0);
  chip_.clock(3);
  EXPECT_TRUE(generator_.stop_state().stopped);
}

TEST_F(StepGeneratorStopTest, takes_nothing_from_the_hit_until_the_acknowledgement) {
  generator_.set_slopes(slope, slope);
  append(line({2000, 0, 0, 0}, rate(0.01)));
  chip_.clock(5000);
  generator_.brake();
  chip_.clock(3);
  EXPECT_TRUE(generator_.stop_state().braking);
  EXPECT_FALSE(generator_.append(line({1000, 0, 0, 0})));
  platform::write(registers::step_generator::SegmentCommit{});
  EXPECT_TRUE(platform::read<registers::step_generator::Errors>().while_stopped);
  EXPECT_EQ(generator_.queued_segments(), 0);
  EXPECT_TRUE(generator_.stop_state().braking);
}

TEST_F(StepGeneratorStopTest, stays_stopped_where_one_word_stops_and_acknowledges) {
  using registers::step_generator::Command;
  for (const Command word : {Command{.stop = true, .acknowledge_stop = true},
                             Command{.acknowledge_stop = true, .brake = true}}) {
    generator_.stop();
    chip_.clock(3);
    platform::write(word);
    chip_.clock(3);
    EXPECT_TRUE(generator_.stop_state().stopped);
    generator_.acknowledge_stop();
    chip_.clock(3);
    EXPECT_FALSE(generator_.stop_state().stopped);
  }
}

TEST_F(StepGeneratorStopTest, stops_at_a_change_only_if_that_is_asked_for) {
  Segment segment = line({1000, 0, 0, 0}, rate(0.01));
  segment.stop_mask = 0b1;
  segment.stop_on_change = true;
  chip_->end_stops = 0b1;  // triggered already
  append(segment);
  chip_.clock(3000);
  EXPECT_TRUE(generator_.moving());
  chip_->end_stops = 0;
  chip_.clock(3000);
  EXPECT_TRUE(generator_.moving());
  chip_->end_stops = 0b1;
  const auto at_stop = pulses_.counts();
  chip_.clock(300);
  EXPECT_TRUE(generator_.stop_state().stopped);
  EXPECT_EQ(pulses_.counts(), at_stop);
  generator_.acknowledge_stop();

  // A probe that is lifted off.
  segment.stop_on_release = true;
  append(segment);
  chip_.clock(3000);
  EXPECT_TRUE(generator_.moving());
  chip_->end_stops = 0;
  chip_.clock(3);
  EXPECT_TRUE(generator_.stop_state().stopped);
}

TEST_F(StepGeneratorStopTest, stops_when_software_does_not_feed_the_watchdog_in_motion) {
  generator_.set_watchdog(5000);
  chip_.clock(20000);
  EXPECT_FALSE(generator_.stop_state().stopped);
  append(line({1000, 0, 0, 0}, rate(0.01)));
  for (int i = 0; i < 10; ++i) {
    chip_.clock(4000);
    generator_.feed_watchdog();
  }
  EXPECT_TRUE(generator_.moving());
  const std::uint64_t fed = chip_.now();
  chip_.clock(6000);
  const auto stop = generator_.stop_state();
  EXPECT_TRUE(stop.stopped);
  EXPECT_TRUE(stop.watchdog);
  EXPECT_FALSE(stop.software);
  EXPECT_NEAR(static_cast<double>(stop.clock - fed), 5000, 3);
  EXPECT_EQ(stop.positions[0], pulses_.counts()[0]);
}

TEST_F(StepGeneratorStopTest, begins_a_waiting_segment_at_the_edge_of_the_start_input) {
  Segment first = line({100, 0, 0, 0}, rate(0.1));
  Segment second = line({0, 100, 0, 0}, rate(0.1));
  first.ends_motion = false;
  second.waits_for_start = true;
  chip_->start = 1;  // a level starts nothing
  append(first);
  append(second);
  chip_.clock(5000);
  EXPECT_TRUE(generator_.waiting());
  EXPECT_FALSE(generator_.moving());
  EXPECT_THAT(generator_.snapshot().positions, ElementsAre(100, 0, 0, 0));
  EXPECT_EQ(generator_.counters().underruns, 0);
  chip_->start = 0;
  chip_.clock(10);
  EXPECT_TRUE(generator_.waiting());
  chip_->start = 1;
  chip_.clock(2);
  EXPECT_FALSE(generator_.waiting());
  EXPECT_TRUE(generator_.moving());
  run_until_idle();
  EXPECT_THAT(generator_.snapshot().positions, ElementsAre(100, 100, 0, 0));
}

TEST_F(StepGeneratorStopTest, remembers_no_start_for_which_nothing_waits) {
  generator_.start();
  Segment segment = line({10, 0, 0, 0});
  segment.waits_for_start = true;
  append(segment);
  chip_.clock(100);
  EXPECT_TRUE(generator_.waiting());
  generator_.start();
  run_until_idle();
  EXPECT_EQ(generator_.snapshot().positions[0], 10);
}

}  // namespace
