// SPDX-License-Identifier: Apache-2.0
// Full rate: a step every second clock on all axes at once, and with both edges a step on each.
#include <array>

#include "platform/bus.hpp"
#include "tests/drivers/step_generator_fixture.hpp"

namespace {

using motion::Segment;

class StepGeneratorRateTest : public tests::StepGeneratorFixture {
 protected:
  static constexpr std::size_t all_axes = 5;

  // Below the driver, which moves four axes: a segment of one tick that steps all of them.
  static void append_tick_of_all_axes() {
    namespace registers = ::registers::step_generator;
    platform::write(registers::SegmentFlags{.ends_motion = true});
    platform::write(registers::SegmentLineTicks{1});
    for (std::size_t axis = 0; axis < all_axes; ++axis) {
      platform::write(axis, registers::SegmentSteps{1});
    }
    platform::write(registers::SegmentTicks{1});
    platform::write(registers::SegmentRate{std::uint64_t{1} << 63u});
    platform::write(registers::SegmentAcceleration{});
    platform::write(registers::SegmentJerk{});
    platform::write(registers::SegmentCommit{});
  }

  static void use_on_all_axes(std::uint32_t clocks, bool both_edges) {
    namespace registers = ::registers::step_generator;
    for (std::size_t axis = 0; axis < all_axes; ++axis) {
      platform::write(
          axis, registers::PulseGuard{.high = clocks, .low = clocks, .both_edges = both_edges});
      platform::write(axis, registers::DirectionGuard{.setup = 1, .hold = 1});
    }
  }
};

TEST_F(StepGeneratorRateTest, steps_all_five_axes_every_second_clock_over_segments_of_one_tick) {
  use_on_all_axes(1, false);
  generator_.permit_motion(false);
  for (std::uint32_t i = 0; i < generator_.queue_depth(); ++i) append_tick_of_all_axes();
  EXPECT_EQ(generator_.queued_segments(), 32);
  generator_.permit_motion(true);
  run_until_idle();
  for (std::size_t axis = 0; axis < all_axes; ++axis) {
    EXPECT_EQ(pulses_.axis(axis).forward, 32) << axis;
    EXPECT_EQ(pulses_.axis(axis).shortest_period, 2) << axis;
    EXPECT_EQ(pulses_.axis(axis).longest_period, 2) << axis;
  }
  EXPECT_EQ(generator_.counters().stall_clocks, 0);
  EXPECT_EQ(generator_.counters().segments, 32);
}

TEST_F(StepGeneratorRateTest, makes_a_step_of_each_edge_for_drivers_with_both_edges) {
  std::array<std::uint64_t, all_axes> toggles{}, last{}, shortest_distance{};
  shortest_distance.fill(~0ull);
  std::uint32_t step = 0;
  chip_.after_clock = [&] {
    for (std::size_t axis = 0; axis < all_axes; ++axis) {
      if (((step ^ chip_->step) >> axis & 1u) == 0) continue;
      if (toggles[axis]++ > 0) {
        shortest_distance[axis] = std::min(shortest_distance[axis], chip_.now() - last[axis]);
      }
      last[axis] = chip_.now();
    }
    step = chip_->step;
  };
  use_on_all_axes(1, true);
  append(line({1001, -1001, 500, 3}));
  run_until_idle();
  EXPECT_THAT(toggles, testing::ElementsAre(1001, 1001, 500, 3, 0));
  EXPECT_EQ(shortest_distance[0], 2);
  EXPECT_THAT(generator_.snapshot().positions, testing::ElementsAre(1001, -1001, 500, 3));
  EXPECT_EQ(generator_.counters().stall_clocks, 0);
  EXPECT_EQ(step, 0b1011);  // odd numbers of steps leave the pin high

  // 7 clocks at least from one toggle to the next.
  use_on_all_axes(7, true);
  toggles.fill(0);
  shortest_distance.fill(~0ull);
  append(line({-1001, 1001, 0, 0}));
  run_until_idle();
  EXPECT_EQ(toggles[0], 1001);
  EXPECT_EQ(shortest_distance[0], 7);
  EXPECT_THAT(generator_.snapshot().positions, testing::ElementsAre(0, 0, 500, 3));
}

TEST_F(StepGeneratorRateTest, keeps_the_times_of_every_driver_chip_at_the_highest_rate) {
  constexpr units::Hertz clock{50'000'000};
  for (const auto& chip : {drivers::a4988, drivers::drv8825, drivers::tmc2209, drivers::tmc5160}) {
    const auto guard = drivers::GuardTimings::of(chip, clock);
    use(guard);
    pulses_ = tests::PulseRecorder();
    for (int i = 0; i < 6; ++i) append(line({i % 2 == 0 ? 9 : -9, 9, 4, 0}));
    run_until_idle();
    const auto& axis = pulses_.axis(0);
    EXPECT_EQ(axis.forward, 27);
    EXPECT_EQ(axis.backward, 27);
    EXPECT_GE(axis.shortest_high * 20, chip.high_ns);
    EXPECT_GE(axis.shortest_low * 20, chip.low_ns);
    EXPECT_GE(axis.shortest_setup * 20, chip.direction_setup_ns);
    EXPECT_GE(axis.shortest_hold * 20, chip.direction_hold_ns);
  }
}

}  // namespace
