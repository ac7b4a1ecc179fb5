// SPDX-License-Identifier: Apache-2.0
// The heaters' driver against the heater control: the conditions for heating, and the trips that
// end it.
#include "drivers/heater_control.hpp"

#include <gtest/gtest.h>
#include <Vheater_control.h>

#include "platform/bus.hpp"
#include "registers/heater_control_registers.hpp"
#include "tests/drivers/verilated_bus.hpp"

namespace {

constexpr std::uint32_t clock_hz = 4'000'000;
constexpr std::uint64_t clocks_per_ms = clock_hz / 1000;

struct Heaters : testing::Test {
  tests::VerilatedPeripheral<Vheater_control> chip{registers::heater_control::base};
  drivers::HeaterControl driver{units::Hertz(clock_hz)};
  bool sensors_work = true;
  bool valid = true;
  std::uint32_t count = 5'000;
  std::uint64_t clocks_open = 0;

  Heaters() {
    chip->clock_frequency_hz = clock_hz;
    chip->more_charges = 15;
    chip.after_clock = [this] {
      clocks_open += chip->gates & 1U;
      show_readings(sensors_work && chip.now() % (10 * clocks_per_ms) == 0);
    };
  }
  // Per channel, from bit 0: updated, valid, count; channel 0 in the upper half.
  void show_readings(bool updated) {
    const std::uint64_t reading =
        std::uint64_t{count} << 2 | (valid ? 2U : 0U) | (updated ? 1U : 0U);
    chip->readings[0] = static_cast<std::uint32_t>(reading);
    chip->readings[1] = static_cast<std::uint32_t>(reading << 2 | reading >> 32);
    chip->readings[2] = static_cast<std::uint32_t>(reading >> 30);
  }
  void run_ms(std::uint64_t milliseconds, bool feeding = true) {
    for (std::uint64_t i = 0; i < milliseconds; ++i) {
      chip.clock(clocks_per_ms);
      if (feeding && i % 10 == 9) feed();
    }
  }
  void feed() {
    driver.feed(drivers::FeedKey::first);
    driver.feed(drivers::FeedKey::second);
  }
  // The cause of the trip must have ended.
  void close_supply() {
    driver.clear_trips(0);
    driver.clear_trips(1);
    driver.close_supply();
  }
  static drivers::HeaterLimits limits(std::uint32_t minimum, std::uint32_t maximum) {
    return {.counts = {.minimum = minimum, .maximum = maximum},
            .hot = 10'000,
            .settle = units::Milliseconds(400)};
  }
  void set_up() {
    driver.set_timeouts(units::Milliseconds(100), units::Milliseconds(200));
    driver.set_slot(units::Microseconds(100));
    EXPECT_TRUE(driver.lock_limits(0, limits(1'000, 90'000)));
    feed();
    run_ms(20);
  }
  bool heats() const { return driver.status(0).gate; }
};

TEST_F(Heaters, heat_when_all_is_well) {
  set_up();
  EXPECT_TRUE(driver.status(0).permitted);
  driver.set_duty(0, 65'535);
  run_ms(300);
  EXPECT_TRUE(heats());
  EXPECT_FALSE(driver.status(0).tripped);
  EXPECT_EQ(chip->gates, 1);
  EXPECT_EQ(chip->__SYM__interrupt, 0);
}

TEST_F(Heaters, keep_their_duty) {
  set_up();
  driver.set_duty(0, 65'535 / 4);
  run_ms(10);
  clocks_open = 0;
  run_ms(400);
  EXPECT_NEAR(static_cast<double>(clocks_open) / (400.0 * clocks_per_ms), 0.25, 0.002);
}

TEST_F(Heaters, go_off_when_the_software_hangs) {
  set_up();
  driver.set_duty(0, 65'535);
  run_ms(50);
  run_ms(98, false);
  EXPECT_TRUE(heats());
  run_ms(4, false);
  EXPECT_FALSE(heats());
  EXPECT_TRUE(driver.status(0).watchdog_trip);
  EXPECT_EQ(chip->__SYM__interrupt, 1);
}

TEST_F(Heaters, stay_off_until_cleared_at_zero_duty) {
  set_up();
  driver.set_duty(0, 65'535);
  run_ms(200, false);
  run_ms(50);
  EXPECT_FALSE(heats());
  driver.clear_trips(0);
  EXPECT_FALSE(driver.status(0).tripped);
  driver.set_duty(0, 65'535);
  run_ms(5);
  EXPECT_TRUE(heats());
}

TEST_F(Heaters, need_limits_that_are_locked_at_the_first_call) {
  driver.set_timeouts(units::Milliseconds(100), units::Milliseconds(200));
  feed();
  run_ms(20);
  driver.set_duty(0, 65'535);
  run_ms(5);
  EXPECT_FALSE(heats());
  EXPECT_TRUE(driver.status(0).limits_missing_trip);
  EXPECT_FALSE(driver.status(0).limits_locked);
  EXPECT_TRUE(driver.lock_limits(0, limits(6'000, 90'000)));
  EXPECT_FALSE(driver.lock_limits(0, limits(0, 0xFFFF'FFFF)));
  EXPECT_TRUE(driver.status(0).limits_locked);
  EXPECT_FALSE(driver.status(1).limits_locked);
  driver.clear_trips(0);
  driver.set_duty(0, 65'535);
  run_ms(5);
  EXPECT_FALSE(heats());
  EXPECT_TRUE(driver.status(0).too_hot_trip);
}

TEST_F(Heaters, name_what_the_sensor_says) {
  set_up();
  const auto trip = [this] {
    run_ms(300);
    EXPECT_FALSE(heats());
    const drivers::HeaterStatus status = driver.status(0);
    sensors_work = valid = true;
    count = 5'000;
    run_ms(20);
    EXPECT_FALSE(heats()) << "forgets";
    driver.clear_trips(0);
    driver.set_duty(0, 65'535);
    run_ms(20);
    EXPECT_TRUE(heats());
    return status;
  };
  driver.set_duty(0, 65'535);
  count = 999;
  EXPECT_TRUE(trip().too_hot_trip);
  count = 90'001;
  EXPECT_TRUE(trip().too_cold_trip);
  valid = false;
  EXPECT_TRUE(trip().sensor_invalid_trip);
  sensors_work = false;
  EXPECT_TRUE(trip().sensor_stale_trip);
  chip->emergency_stop = 1;
  run_ms(1);
  chip->emergency_stop = 0;
  EXPECT_TRUE(trip().emergency_stop_trip);
}

TEST_F(Heaters, cannot_be_given_endless_patience) {
  driver.set_timeouts(units::Milliseconds(60'000), units::Milliseconds(60'000));
  const auto ticks = platform::read<registers::heater_control::Watchdog>().ticks;
  EXPECT_LE(1.0 * ticks * registers::heater_control::tick_cycles / clock_hz, 3.0);
  EXPECT_GT(1.0 * ticks * registers::heater_control::tick_cycles / clock_hz, 2.9);
}

TEST_F(Heaters, refuse_limits_beyond_what_any_machine_needs) {
  set_up();
  // 15 clocks for each of 16 charges: 3.8 us.
  EXPECT_FALSE(driver.lock_limits(1, limits(239, 90'000)));
  EXPECT_TRUE(driver.status(1).refused);
  EXPECT_FALSE(driver.status(1).limits_locked);
  driver.clear_trips(1);
  EXPECT_FALSE(driver.status(1).refused);
  EXPECT_TRUE(driver.lock_limits(1, limits(240, 90'000)) || driver.status(1).limits_locked);
  EXPECT_EQ(platform::read<registers::heater_control::MinimumCount>(1).cycles, 240u);
}

TEST_F(Heaters, take_limits_of_a_program_before_that_are_nearly_the_same) {
  set_up();
  EXPECT_TRUE(driver.lock_limits(0, limits(1'030, 91'000)));
  EXPECT_FALSE(driver.lock_limits(0, limits(1'040, 91'000)));
}

TEST_F(Heaters, go_off_when_fed_by_one_loop_alone_or_too_fast) {
  set_up();
  driver.set_duty(0, 65'535);
  run_ms(20);
  EXPECT_TRUE(heats());
  driver.feed(drivers::FeedKey::second);
  chip.clock(3);
  EXPECT_TRUE(driver.status(0).watchdog_trip);
  EXPECT_TRUE(driver.status(1).watchdog_trip);
  driver.clear_trips(0);
  run_ms(20);
  driver.set_duty(0, 65'535);
  run_ms(15);
  EXPECT_TRUE(heats());
  feed();
  feed();
  chip.clock(3);
  EXPECT_TRUE(driver.status(0).watchdog_trip);
}

TEST_F(Heaters, have_a_supply_that_any_trip_opens) {
  set_up();
  EXPECT_EQ(chip->supply, 0);
  driver.set_duty(0, 65'535);
  run_ms(5);
  driver.close_supply();
  EXPECT_FALSE(driver.supply().closed);
  EXPECT_TRUE(driver.supply().refused);
  close_supply();
  run_ms(1);
  EXPECT_TRUE(driver.supply().closed);
  EXPECT_EQ(chip->supply, 1);
  driver.open_supply();
  run_ms(1);
  EXPECT_EQ(chip->supply, 0);
  close_supply();
  count = 999;  // at duty 0
  run_ms(20);
  EXPECT_EQ(chip->supply, 0);
  EXPECT_TRUE(driver.supply().trip_opened);
  EXPECT_TRUE(driver.status(0).too_hot_trip);
  count = 5'000;
  run_ms(20);
  EXPECT_EQ(chip->supply, 0) << "forgets";
  close_supply();
  EXPECT_TRUE(driver.supply().closed);
  chip->veto = 1;
  run_ms(1);
  EXPECT_TRUE(driver.supply().veto_opened);
  chip->veto = 0;
  close_supply();
  run_ms(200, false);
  EXPECT_TRUE(driver.supply().watchdog_opened);
  EXPECT_EQ(chip->supply, 0);
}

TEST_F(Heaters, find_a_transistor_that_conducts_by_itself) {
  set_up();
  close_supply();
  run_ms(500);
  EXPECT_TRUE(driver.supply().closed);
  count = 4'400;
  run_ms(30);
  EXPECT_TRUE(driver.supply().closed);
  count = 4'300;
  run_ms(30);
  EXPECT_FALSE(driver.supply().closed);
  EXPECT_TRUE(driver.status(0).heats_unasked_trip);
}

}  // namespace
