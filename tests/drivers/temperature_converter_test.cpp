// SPDX-License-Identifier: Apache-2.0
// The converter's driver against the converter, with simulated capacitors and thermistors on
// its pins.
#include "drivers/temperature_converter.hpp"

#include <gtest/gtest.h>
#include <Vtemperature_converter.h>

#include <array>
#include <cmath>

#include "registers/temperature_converter_registers.hpp"
#include "sim/devices/thermistor_input.hpp"
#include "sim/machine/board_signals.hpp"
#include "tests/drivers/verilated_bus.hpp"
#include "tests/thermal/ntc.hpp"

namespace {

using thermal::SensorState;

// A chip at this clock with a hotend's and a bed's sensor.
struct Converter {
  explicit Converter(double clock_hz)
      : hertz(clock_hz), driver(units::Hertz(static_cast<std::uint32_t>(clock_hz))) {
    chip->clock_frequency_hz = static_cast<std::uint32_t>(clock_hz);
    chip.after_clock = [this] {
      const double now = static_cast<double>(chip.now()) / hertz;
      for (unsigned i = 0; i < inputs.size(); ++i) {
        inputs[i].set_pins(now, chip->drive_enable >> (3 * i) & 7,
                           chip->drive_level >> (3 * i) & 7);
        sense = inputs[i].sense(now) ? sense | 1U << i : sense & ~(1U << i);
      }
      chip->sense = static_cast<CData>(sense);
    };
  }
  static devices::ThermistorInputProperties circuit() {
    return {.thermistor = {100e3, 4066},
            .capacitor_farads = 68e-9 * 0.93,
            .reference_low_ohms = 470,
            .reference_high_ohms = 10e3,
            .supply_volts = 3.3,
            .threshold_volts = 1.4};
  }
  drivers::ConverterSettings settings() const {
    drivers::ConverterSettings settings{.charges = 16,
                                        .discharge = units::Microseconds(400),
                                        .longest_charge = units::Microseconds(60'000),
                                        .pause = units::Microseconds(1'000)};
    settings.short_limit = thermal::Sensor::short_limit(
        tests::ntc_table,
        {tests::picoseconds_per_ohm, units::Hertz(static_cast<std::uint32_t>(hertz)), 16,
         drivers::TemperatureConverter::delay_cycles});
    return settings;
  }
  void run(double seconds) { chip.clock(static_cast<std::uint64_t>(seconds * hertz)); }
  double celsius(std::size_t channel) const {
    const auto measured = sensor.temperature(driver.reading(channel));
    return measured ? measured->count() / 1000.0 : std::nan("");
  }

  double hertz;
  tests::VerilatedPeripheral<Vtemperature_converter> chip{registers::temperature_converter::base};
  double hotend = 200, bed = 60;
  unsigned sense = 0;
  std::array<devices::ThermistorInput, 2> inputs{
      devices::ThermistorInput(
          circuit(), [this](double) { return hotend; }, 1),
      devices::ThermistorInput(circuit(), [this](double) { return bed; }, 2)};
  drivers::TemperatureConverter driver;
  thermal::Sensor sensor{tests::ntc_table, tests::references};
};

TEST(temperature_converter, says_nothing_before_the_first_conversion) {
  Converter converter(4e6);
  EXPECT_EQ(converter.driver.reading(0).state, SensorState::never);
  EXPECT_GT(converter.driver.reading(0).age.count(), 10'000);
}

TEST(temperature_converter, measures_within_half_a_degree_at_4_mhz_with_wrong_parts) {
  Converter converter(4e6);
  converter.driver.start(converter.settings());
  for (const double celsius : {25.0, 120.0, 180.0, 205.0, 250.0}) {
    converter.hotend = celsius;
    converter.run(0.25);
    EXPECT_NEAR(converter.celsius(0), celsius, 0.5);
    EXPECT_NEAR(converter.celsius(1), 60, 0.5);
    EXPECT_LT(converter.driver.reading(0).age.count(), 130);
  }
}

TEST(temperature_converter, converts_more_than_ten_times_a_second_when_hot) {
  Converter converter(4e6);
  converter.driver.start(converter.settings());
  converter.run(0.05);
  const std::uint8_t before = converter.driver.reading(0).conversions;
  converter.run(0.5);
  EXPECT_GE(static_cast<std::uint8_t>(converter.driver.reading(0).conversions - before), 10);
}

TEST(temperature_converter, measures_finer_at_a_faster_clock) {
  Converter converter(20e6);
  converter.driver.start(converter.settings());
  for (const double celsius : {200.0, 200.4}) {
    converter.hotend = celsius;
    converter.run(0.07);
    EXPECT_NEAR(converter.celsius(0), celsius, 0.3);
  }
}

TEST(temperature_converter, names_each_fault_and_finds_back) {
  Converter converter(4e6);
  converter.driver.start(converter.settings());
  const auto state_with = [&converter](devices::SensorFault fault) {
    converter.inputs[0].set_fault(static_cast<double>(converter.chip.now()) / converter.hertz,
                                  fault);
    converter.run(0.3);
    return converter.driver.reading(0).state;
  };
  EXPECT_EQ(state_with(devices::SensorFault::open), SensorState::open);
  EXPECT_EQ(state_with(devices::SensorFault::shorted), SensorState::shorted);
  EXPECT_EQ(state_with(devices::SensorFault::sense_stuck_high), SensorState::stuck);
  EXPECT_EQ(state_with(devices::SensorFault::sense_stuck_low), SensorState::time_out);
  EXPECT_EQ(state_with(devices::SensorFault::none), SensorState::ok);
  EXPECT_EQ(converter.driver.reading(1).state, SensorState::ok);
}

// The reading of a hotend's sensor with these pulls at its pins.
thermal::SensorReading reading_with(const devices::SensorPulls& pulls, devices::SensorFault fault,
                                    double celsius) {
  Converter converter(4e6);
  auto properties = Converter::circuit();
  properties.pulls = pulls;
  converter.inputs[0] =
      devices::ThermistorInput(properties, [celsius](double) { return celsius; }, 3);
  converter.inputs[0].set_fault(0, fault);
  converter.driver.start(converter.settings());
  converter.run(0.25);
  return converter.driver.reading(0);
}

// As the references say it, however little they fit their own resistors.
double ohms_of(const thermal::SensorReading& reading) {
  const double low = reading.reference_low;
  return 470 + (reading.thermistor - low) / (reading.reference_high - low) * (10e3 - 470);
}

devices::SensorPulls pull_ups(double ohms) {
  return {.resistor_pins = devices::Pull::up, .sense_pin = devices::Pull::up, .ohms = ohms};
}

TEST(temperature_converter, finds_an_open_thermistor_with_the_pulls_of_the_boards) {
  const auto reading = reading_with(machine::sensor_pulls(), devices::SensorFault::open, 200);
  EXPECT_EQ(reading.state, SensorState::open);
}

// Why sensor pins must have no pull.
TEST(temperature_converter, takes_an_open_thermistor_for_a_cold_one_where_pins_are_pulled_up) {
  for (const auto& [pull_ohms, read_ohms] : {std::pair{22e3, 16e3}, {110e3, 45e3}}) {
    const auto open = reading_with(pull_ups(pull_ohms), devices::SensorFault::open, 200);
    EXPECT_EQ(open.state, SensorState::ok);
    EXPECT_NEAR(ohms_of(open), read_ohms, 0.02 * read_ohms);
    // Strong pulls make the references implausible too, weak ones do not.
    const thermal::Sensor sensor(tests::ntc_table, tests::references);
    EXPECT_EQ(sensor.temperature(open).has_value(), pull_ohms == 110e3);
  }
}

TEST(temperature_converter, reads_a_hot_thermistor_too_cold_where_pins_are_pulled_up) {
  constexpr double celsius_at_500_ohms = 214.43;
  const auto reads = [](const devices::SensorPulls& pulls) {
    return ohms_of(reading_with(pulls, devices::SensorFault::none, celsius_at_500_ohms));
  };
  EXPECT_NEAR(reads(machine::sensor_pulls()), 500, 2);
  EXPECT_NEAR(reads(pull_ups(110e3)), 507, 2);
  EXPECT_NEAR(reads(pull_ups(22e3)), 539, 3);
}

TEST(temperature_converter, works_with_a_thermistor_alone) {
  Converter converter(4e6);
  auto properties = Converter::circuit();
  properties.references = false;
  properties.capacitor_farads = 68e-9;
  properties.threshold_volts = 1.65;
  converter.inputs[0] = devices::ThermistorInput(properties, [](double) { return 200.0; }, 3);
  auto settings = converter.settings();
  settings.references = false;
  converter.driver.start(settings);
  converter.run(0.1);
  const thermal::Sensor alone(
      tests::ntc_table, thermal::NominalCircuit{tests::picoseconds_per_ohm, units::Hertz(4'000'000),
                                                16, drivers::TemperatureConverter::delay_cycles});
  const auto measured = alone.temperature(converter.driver.reading(0));
  ASSERT_TRUE(measured);
  // The pin's 25 ohms are not known here: 4 % of 645 ohms, more than 2 degrees.
  EXPECT_NEAR(measured->count() / 1000.0, 198, 1.5);
}

TEST(temperature_converter, lets_the_pins_go_when_stopped) {
  Converter converter(4e6);
  converter.driver.start(converter.settings());
  converter.run(0.05);
  converter.driver.stop();
  converter.run(0.001);
  EXPECT_EQ(converter.chip->drive_enable, 0);
  EXPECT_EQ(converter.driver.reading(0).state, SensorState::ok);
  converter.run(0.1);
  EXPECT_GE(converter.driver.reading(0).age.count(), 95);
}

}  // namespace
