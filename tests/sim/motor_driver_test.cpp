// SPDX-License-Identifier: Apache-2.0
// A motor driver takes what its data sheet permits, and nothing else.
#include "sim/devices/motor_driver.hpp"

#include <gmock/gmock.h>

#include "sim/simulation/simulation.hpp"
#include "tests/sim/fake_chip.hpp"

namespace {

// An A4988 at 10 MHz: 10 clocks high, 10 clocks low, 2 clocks of set-up and hold.
constexpr devices::DriverTiming a4988{1000, 1000, 200, 200};
constexpr sim::ClockRate rate(10'000'000);
constexpr plants::AxisProperties strong_axis{.steps_per_mm = 80,
                                             .torque_acceleration = 1e9,
                                             .speed_limit = 1e6,
                                             .lower_frame = {},
                                             .upper_frame = {}};

struct Edges : devices::StepListener {
  void stepped(const devices::StepEdge& edge) override { all.push_back(edge); }
  std::vector<devices::StepEdge> all;
};

class MotorDriverTest : public testing::Test {
 protected:
  MotorDriverTest() {
    simulation.attach(driver, sim::OutputPins::motor_pins(0));
    driver.add_listener(edges);
    chip.plan(1, sim::OutputPins::enable_bit, true);
  }

  tests::FakeChip chip;
  sim::Simulation simulation{chip, rate};
  plants::Axis axis{strong_axis, 100};
  devices::MotorDriver driver{0, a4988, rate, axis};
  Edges edges;
};

TEST_F(MotorDriverTest, moves_one_step_for_each_legal_pulse) {
  chip.plan_step(1000, 0, false, 10, 2);
  chip.plan_step(2000, 0, true, 10, 2);
  chip.plan_step(3000, 0, true, 10, 2);
  simulation.run_until(4000);
  EXPECT_EQ(axis.position(), 99);
  EXPECT_EQ(driver.counts().forward, 1U);
  EXPECT_EQ(driver.counts().backward, 2U);
  EXPECT_EQ(driver.counts().illegal, 0U);
  ASSERT_EQ(edges.all.size(), 3U);
  EXPECT_EQ(edges.all[0].clock, 1000U);
  EXPECT_EQ(edges.all[0].position, 101);
  EXPECT_EQ(edges.all[2].direction, -1);
}

TEST_F(MotorDriverTest, loses_a_pulse_that_is_high_for_one_clock_too_few) {
  chip.plan_step(1000, 0, false, 9);
  simulation.run_until(2000);
  EXPECT_EQ(driver.counts().illegal, 1U);
  EXPECT_EQ(axis.position(), 100);
}

TEST_F(MotorDriverTest, takes_pulses_at_the_shortest_low_time_and_loses_those_below) {
  chip.plan_step(1000, 0, false, 10);
  chip.plan_step(1020, 0, false, 10, 5);
  simulation.run_until(1100);
  EXPECT_EQ(driver.counts().illegal, 0U);
  chip.plan_step(2000, 0, false, 10);
  chip.plan_step(2019, 0, false, 10, 5);
  simulation.run_until(3000);
  EXPECT_EQ(driver.counts().illegal, 1U);
  EXPECT_EQ(axis.position(), 103);
}

TEST_F(MotorDriverTest, loses_a_step_whose_direction_came_too_late) {
  chip.plan_step(1000, 0, true, 10, 1);
  simulation.run_until(2000);
  EXPECT_EQ(driver.counts().illegal, 1U);
  EXPECT_EQ(axis.position(), 100);
}

TEST_F(MotorDriverTest, loses_a_step_whose_direction_changes_at_the_edge_itself) {
  chip.plan(1000, sim::OutputPins::direction_bit, true);
  chip.plan(1000, sim::OutputPins::step_bit, true);
  chip.plan(1020, sim::OutputPins::step_bit, false);
  simulation.run_until(2000);
  EXPECT_EQ(driver.counts().illegal, 1U);
  EXPECT_EQ(axis.position(), 100);
}

TEST_F(MotorDriverTest, loses_a_step_whose_direction_is_not_held) {
  chip.plan_step(1000, 0, false, 10);
  chip.plan(1001, sim::OutputPins::direction_bit, true);
  simulation.run_until(2000);
  EXPECT_EQ(driver.counts().illegal, 1U);
  EXPECT_EQ(axis.position(), 100);
}

TEST_F(MotorDriverTest, counts_a_pulse_with_two_violations_once) {
  chip.plan_step(1000, 0, false, 3);
  chip.plan(1001, sim::OutputPins::direction_bit, true);
  simulation.run_until(2000);
  EXPECT_EQ(driver.counts().illegal, 1U);
  EXPECT_EQ(axis.position(), 100);
}

TEST_F(MotorDriverTest, does_not_move_while_it_is_off) {
  chip.plan(500, sim::OutputPins::enable_bit, false);
  chip.plan_step(1000, 0, false, 10);
  simulation.run_until(2000);
  EXPECT_EQ(driver.counts().disabled, 1U);
  EXPECT_EQ(driver.counts().forward, 1U);
  EXPECT_EQ(axis.position(), 100);
}

TEST_F(MotorDriverTest, is_not_called_for_pins_of_other_axes) {
  chip.plan_step(1000, 1, false, 10);
  simulation.run_until(2000);
  EXPECT_TRUE(edges.all.empty());
}

}  // namespace
