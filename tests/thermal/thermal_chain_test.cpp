// SPDX-License-Identifier: Apache-2.0
// From capacitor to heater: logic, drivers, Verilated hardware and simulated hotend in one loop.
#include <gtest/gtest.h>
#include <Vthermal_chain.h>

#include <cmath>

#include "drivers/heater_control.hpp"
#include "drivers/temperature_converter.hpp"
#include "platform/bus.hpp"
#include "registers/heater_control_registers.hpp"
#include "registers/temperature_converter_registers.hpp"
#include "sim/devices/thermistor_input.hpp"
#include "sim/machine/surroundings.hpp"
#include "tests/drivers/verilated_bus.hpp"
#include "tests/plants/described_heaters.hpp"
#include "tests/thermal/ntc.hpp"
#include "thermal/heater_loop.hpp"

namespace {

using tests::celsius;

constexpr std::uint32_t clock_hz = 4'000'000;
constexpr double target = 205;
constexpr double start = 200;
constexpr std::uint32_t charges = 16;

// The second page of the one model.
struct HeaterPage : tests::ClockedPeripheral {
  explicit HeaterPage(tests::ClockedPeripheral& chip)
      : ClockedPeripheral(registers::heater_control::base), chip_(chip) {}
  std::uint32_t read(std::uint32_t address) override { return chip_.read(address); }
  void write(std::uint32_t address, std::uint32_t value) override { chip_.write(address, value); }

 private:
  tests::ClockedPeripheral& chip_;
};

struct Chain : testing::Test {
  Chain() {
    chip->clock_frequency_hz = clock_hz;
    chip.after_clock = [this] { connect(); };
    control.set_timeouts(units::Milliseconds(500), units::Milliseconds(500));
    control.set_slot(units::Microseconds(2'000));
    converter.start({.charges = charges,
                     .discharge = units::Microseconds(400),
                     .longest_charge = units::Microseconds(60'000),
                     .pause = units::Microseconds(1'000),
                     .short_limit = 16 * 10});
  }
  static thermal::HeaterSettings settings() {
    thermal::HeaterSettings settings;
    settings.maximum = celsius(275);
    settings.gains = {9'830, 524, 58'982, 98};
    settings.arrival.residency = units::Milliseconds(2'000);
    return settings;
  }
  double now() const { return static_cast<double>(chip.now()) / clock_hz; }

  // After each clock: cheap where no pin has changed.
  void connect() {
    const auto pins = static_cast<unsigned>(chip->drive_enable & 7) << 4 |
                      static_cast<unsigned>(chip->drive_level & 7) << 1 | (chip->gates & 1U) |
                      (chip->supply & 1U) << 7;
    if (pins == pins_before && chip.now() < next_look) return;
    pins_before = pins;
    block.set_supply(now(), (chip->supply & 1) != 0);
    block.set_heater(now(), (chip->gates & 1) != 0);
    input.set_pins(now(), chip->drive_enable & 7, chip->drive_level & 7);
    chip->sense = input.sense(now());
    const double change = input.next_change() * clock_hz;
    next_look = change > static_cast<double>(chip.now()) && std::isfinite(change)
                    ? static_cast<std::uint64_t>(std::ceil(change))
                    : UINT64_MAX;
  }
  void feed() {
    control.feed(drivers::FeedKey::first);
    control.feed(drivers::FeedKey::second);
  }
  // One period of the firmware's task.
  void update() {
    const auto reading = converter.reading(0);
    const auto temperature = sensor.temperature(reading);
    if (!limits_locked && temperature) {
      limits_locked =
          control.lock_limits(0, {.counts = *sensor.limits(celsius(-5), celsius(285), reading),
                                  .hot = sensor.limits(celsius(-5), celsius(140), reading)->minimum,
                                  .settle = settle});
    }
    feed();
    if (limits_locked && !control.supply().closed) control.close_supply();
    if (control.status(0).tripped) loop.report_cut_off();
    const auto milliseconds = static_cast<std::int64_t>(now() * 1000);
    control.set_duty(0, loop.update(temperature, units::Milliseconds(milliseconds)));
    chip.clock(clock_hz / 10);
  }
  // Meanwhile the temperatures lie between the two.
  void run(double seconds) {
    for (const double end = now() + seconds; now() < end;) {
      update();
      lowest = std::min(lowest, block.celsius(now()));
      highest = std::max(highest, block.celsius(now()));
    }
  }

  tests::VerilatedPeripheral<Vthermal_chain> chip{registers::temperature_converter::base};
  HeaterPage heater_page{chip};
  plants::HeatedBlock block{tests::described_hotend(), 22, start};
  devices::ThermistorInput input{{.thermistor = {100e3, 4066},
                                  .capacitor_farads = 73e-9,
                                  .reference_low_ohms = 470,
                                  .reference_high_ohms = 10e3,
                                  .supply_volts = 3.3,
                                  .threshold_volts = 1.5},
                                 [this](double seconds) { return block.sensor_celsius(seconds); },
                                 1};
  unsigned pins_before = 0;
  std::uint64_t next_look = 0;
  drivers::TemperatureConverter converter{units::Hertz(clock_hz)};
  drivers::HeaterControl control{units::Hertz(clock_hz)};
  thermal::Sensor sensor{tests::ntc_table, tests::references};
  thermal::HeaterLoop loop{settings()};
  static constexpr units::Milliseconds settle{1'000};
  bool limits_locked = false;
  double lowest = 1e9, highest = -1e9;
};

TEST_F(Chain, holds_its_target_and_cuts_off_when_the_firmware_hangs) {
  run(0.5);
  EXPECT_LT(highest, start + 0.5) << "heats without a target";
  loop.set_target(celsius(target));
  for (int i = 0; i < 300 && !loop.at_target(); ++i) update();
  ASSERT_TRUE(loop.at_target());
  highest = lowest = target;
  run(3);
  EXPECT_LT(highest, target + 2);
  EXPECT_GT(lowest, target - 2);
  EXPECT_EQ(loop.fault(), std::nullopt);

  // The last duty stands and there is no feed.
  control.set_duty(0, thermal::full_duty);
  chip.clock(clock_hz);
  EXPECT_FALSE(control.status(0).gate);
  EXPECT_TRUE(control.status(0).watchdog_trip);
  update();
  EXPECT_EQ(loop.fault(), thermal::Fault::cut_off);
}

TEST_F(Chain, cuts_off_by_itself_on_a_broken_sensor_while_software_insists) {
  run(0.2);
  control.set_duty(0, 20'000);
  const auto insist = [this](int tenths) {
    for (int i = 0; i < tenths; ++i) {
      feed();
      chip.clock(clock_hz / 10);
    }
  };
  insist(5);
  EXPECT_TRUE(control.status(0).permitted);
  input.set_fault(now(), devices::SensorFault::open);
  insist(2);
  EXPECT_FALSE(control.status(0).permitted);
  insist(6);
  EXPECT_TRUE(control.status(0).sensor_invalid_trip);
}

TEST_F(Chain, cuts_off_by_itself_at_the_highest_temperature_while_software_insists) {
  run(0.2);
  auto strong = tests::described_hotend();
  strong.heater_watts = 600;
  block = plants::HeatedBlock(strong, 22, 200);
  block.set_fault(now(), plants::HeaterFault::stuck_on);
  // Now and then the gate opens, so that heat is not unasked for.
  control.set_duty(0, 200);
  double cut_off = 0;
  for (int i = 0; i < 200 && cut_off == 0; ++i) {
    feed();
    chip.clock(clock_hz / 25);
    if (control.status(0).tripped) cut_off = block.sensor_celsius(now());
  }
  EXPECT_TRUE(control.status(0).too_hot_trip);
  EXPECT_NEAR(cut_off, 285, 6);
}

TEST_F(Chain, cuts_the_supply_when_a_closed_gate_heats) {
  run(0.5);
  loop.set_target(celsius(210));
  run(3);
  EXPECT_TRUE(control.supply().closed);
  loop.set_target(thermal::HeaterLoop::off);
  run(3);
  EXPECT_TRUE(control.supply().closed) << "by the heat that was on its way";
  const double before = block.celsius(now());
  block.set_fault(now(), plants::HeaterFault::stuck_on);
  highest = 0;
  for (int i = 0; i < 150 && control.supply().closed; ++i) {
    feed();
    chip.clock(clock_hz / 10);
  }
  EXPECT_FALSE(control.supply().closed);
  EXPECT_TRUE(control.status(0).heats_unasked_trip);
  EXPECT_LT(block.celsius(now()), before + 15);
}

// Sixteen times the charges make a count sixteen times as large: what is too hot looked cold.
TEST_F(Chain, keeps_its_limits_when_the_converter_is_set_otherwise) {
  run(0.3);
  ASSERT_TRUE(limits_locked);
  block = plants::HeatedBlock(tests::described_hotend(), 22, 340);
  platform::write(registers::temperature_converter::Control{
      .enable = true, .references = true, .dither_cycles = 1, .more_charges = 255});
  EXPECT_TRUE(converter.refused_settings());
  bool opened = false;
  for (int i = 0; i < 20; ++i) {
    feed();
    control.clear_trips(0);
    control.set_duty(0, thermal::full_duty);
    chip.clock(clock_hz / 20);
    opened = opened || control.status(0).gate;
  }
  EXPECT_FALSE(opened) << "heats at " << block.sensor_celsius(now()) << " degrees";
}

}  // namespace
