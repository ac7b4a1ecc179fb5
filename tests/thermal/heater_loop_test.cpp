// SPDX-License-Identifier: Apache-2.0
// When a heater may heat, and that after any fault it does not.
#include "thermal/heater_loop.hpp"

#include <gtest/gtest.h>

#include "tests/thermal/ntc.hpp"

namespace {

using tests::celsius;
using thermal::Fault;
using thermal::HeaterLoop;
using units::Milliseconds;

struct Loop : testing::Test {
  static thermal::HeaterSettings settings() {
    thermal::HeaterSettings settings;
    settings.maximum = celsius(275);
    settings.gains = {9'830, 524, 58'982, 98};
    return settings;
  }

  HeaterLoop loop{settings()};
  std::int64_t now = 0;

  thermal::Duty update(thermal::Temperature measured) {
    now += 100;
    return loop.update(measured, Milliseconds(now));
  }
  thermal::Duty update(double degrees) { return update(thermal::Temperature(celsius(degrees))); }
  thermal::Duty fail(Fault fault) { return update(std::unexpected(fault)); }
  thermal::Duty fail_for(Fault fault, int updates) {
    thermal::Duty most = 0;
    for (int i = 0; i < updates; ++i) most = std::max(most, fail(fault));
    return most;
  }
};

TEST_F(Loop, is_off_at_first) {
  EXPECT_EQ(update(25), 0);
  EXPECT_TRUE(loop.at_target());
  EXPECT_EQ(loop.temperature(), celsius(25));
}

TEST_F(Loop, heats_fully_far_below_the_target_and_not_at_all_above) {
  loop.set_target(celsius(205));
  EXPECT_EQ(update(25), thermal::full_duty);
  EXPECT_FALSE(loop.at_target());
  EXPECT_EQ(update(230), 0);
}

TEST_F(Loop, cuts_targets_to_what_the_machine_may_reach) {
  loop.set_target(celsius(500));
  EXPECT_EQ(loop.target(), celsius(260));
  loop.set_target(celsius(-20));
  EXPECT_EQ(loop.target(), HeaterLoop::off);
}

TEST_F(Loop, never_heats_on_any_sensor_fault) {
  for (const Fault fault :
       {Fault::sensor_open, Fault::sensor_short, Fault::sensor_stuck, Fault::sensor_time_out,
        Fault::sensor_stale, Fault::sensor_implausible}) {
    loop = HeaterLoop(settings());
    loop.set_target(celsius(205));
    EXPECT_GT(update(25), 0);
    EXPECT_EQ(fail_for(fault, 6), 0);
    EXPECT_EQ(loop.fault(), std::nullopt) << "too early";
    EXPECT_EQ(fail_for(fault, 2), 0);
    EXPECT_EQ(loop.fault(), fault);
    EXPECT_EQ(loop.temperature(), std::nullopt);
    EXPECT_EQ(update(25), 0) << "heats again";
    loop.set_target(celsius(205));
    EXPECT_EQ(update(25), 0) << "heats again";
  }
}

TEST_F(Loop, bears_a_single_faulty_conversion) {
  loop.set_target(celsius(205));
  update(25);
  for (int i = 0; i < 50; ++i) {
    EXPECT_EQ(fail(Fault::sensor_stuck), 0);
    EXPECT_GT(update(25 + i), 0);
  }
  EXPECT_EQ(loop.fault(), std::nullopt);
}

TEST_F(Loop, does_without_the_sensor_of_a_heater_that_is_off) {
  EXPECT_EQ(fail_for(Fault::sensor_open, 100), 0);
  EXPECT_EQ(loop.fault(), std::nullopt);
  loop.set_target(celsius(60));
  EXPECT_EQ(fail(Fault::sensor_open), 0);
  EXPECT_EQ(loop.fault(), Fault::sensor_open);
}

TEST_F(Loop, knows_its_highest_and_lowest_temperature) {
  EXPECT_EQ(update(276), 0);
  EXPECT_EQ(loop.fault(), Fault::max_temperature);

  loop = HeaterLoop(settings());
  EXPECT_EQ(update(4), 0);
  EXPECT_EQ(loop.fault(), std::nullopt);
  loop.set_target(celsius(205));
  EXPECT_EQ(update(4), 0);
  EXPECT_EQ(loop.fault(), Fault::min_temperature);
}

TEST_F(Loop, keeps_the_first_fault_until_it_is_cleared) {
  loop.set_target(celsius(205));
  update(25);
  loop.report_cut_off();
  EXPECT_EQ(update(300), 0);
  EXPECT_EQ(loop.fault(), Fault::cut_off);
  EXPECT_EQ(loop.target(), HeaterLoop::off);
  loop.clear_fault();
  EXPECT_EQ(loop.fault(), std::nullopt);
  EXPECT_EQ(update(25), 0);
  loop.set_target(celsius(205));
  EXPECT_EQ(update(25), thermal::full_duty);
}

TEST_F(Loop, finds_that_the_thermistor_has_fallen_out) {
  loop.set_target(celsius(205));
  for (int i = 0; i < 250 && !loop.fault(); ++i) update(25);
  EXPECT_EQ(loop.fault(), Fault::heating_failed);
  EXPECT_EQ(loop.duty(), 0);
}

}  // namespace
