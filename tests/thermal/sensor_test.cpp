// SPDX-License-Identifier: Apache-2.0
// From charge times to temperatures: accuracy, what cancels, and what is refused.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/thermal/ntc.hpp"

namespace {

using tests::celsius;
using thermal::Fault;
using thermal::SensorReading;
using thermal::SensorState;
using units::Milliohms;

double ntc_ohms(double degrees) {
  return 100e3 * std::exp(4066.0 * (1.0 / (degrees + 273.15) - 1.0 / 298.15));
}

// Charge times of a circuit whose parts are as they are.
struct Circuit {
  double capacitor = 68e-9;
  double threshold = 0.5;  // of the supply
  double pin_ohms = 0;
  double clock_hz = 50e6;
  double delay_cycles = 2;
  std::uint32_t charges = 16;

  std::uint32_t count(double ohms) const {
    const double seconds = (ohms + pin_ohms) * capacitor * -std::log(1 - threshold);
    return static_cast<std::uint32_t>(charges * (seconds * clock_hz + delay_cycles));
  }
  SensorReading reading(double ohms) const {
    return {.state = SensorState::ok,
            .thermistor = count(ohms),
            .reference_low = count(470),
            .reference_high = count(10e3)};
  }
};

const thermal::Sensor sensor(tests::ntc_table, tests::references);

double measured(const SensorReading& reading) {
  const auto temperature = sensor.temperature(reading);
  return temperature ? temperature->count() / 1000.0 : std::nan("");
}

TEST(sensor, follows_the_beta_formula_within_a_tenth_of_a_degree) {
  for (double degrees = -9; degrees < 299; degrees += 0.7) {
    EXPECT_NEAR(measured(Circuit{}.reading(ntc_ohms(degrees))), degrees, 0.1) << degrees;
  }
}

TEST(sensor, does_not_care_for_capacitor_threshold_and_pin) {
  for (const Circuit& circuit :
       {Circuit{.capacitor = 75e-9}, Circuit{.capacitor = 61e-9}, Circuit{.threshold = 0.35},
        Circuit{.threshold = 0.65}, Circuit{.pin_ohms = 50}, Circuit{.delay_cycles = 30}}) {
    for (const double degrees : {0.0, 25.0, 100.0, 205.0, 250.0}) {
      EXPECT_NEAR(measured(circuit.reading(ntc_ohms(degrees))), degrees, 0.15) << degrees;
    }
  }
}

TEST(sensor, works_without_references_as_well_as_its_parts_are_nominal) {
  const Circuit circuit{.clock_hz = 60e6};
  const thermal::Sensor alone(
      tests::ntc_table,
      thermal::NominalCircuit{tests::picoseconds_per_ohm, units::Hertz(60'000'000), 16, 2});
  for (const double degrees : {25.0, 100.0, 205.0, 250.0}) {
    const auto temperature = alone.temperature(
        {.state = SensorState::ok, .thermistor = circuit.count(ntc_ohms(degrees))});
    ASSERT_TRUE(temperature);
    EXPECT_NEAR(temperature->count() / 1000.0, degrees, 0.1);
  }
}

TEST(sensor, names_what_the_hardware_found) {
  SensorReading reading = Circuit{}.reading(1'000);
  const auto fault_of = [&reading](SensorState state) {
    reading.state = state;
    return sensor.temperature(reading).error();
  };
  EXPECT_EQ(fault_of(SensorState::open), Fault::sensor_open);
  EXPECT_EQ(fault_of(SensorState::shorted), Fault::sensor_short);
  EXPECT_EQ(fault_of(SensorState::stuck), Fault::sensor_stuck);
  EXPECT_EQ(fault_of(SensorState::time_out), Fault::sensor_time_out);
  EXPECT_EQ(fault_of(SensorState::never), Fault::sensor_stale);
}

TEST(sensor, refuses_what_cannot_be) {
  const auto fault_of = [](const SensorReading& reading) {
    const auto temperature = sensor.temperature(reading);
    return temperature ? std::optional<Fault>() : std::optional<Fault>(temperature.error());
  };
  const SensorReading good = Circuit{}.reading(1'000);
  ASSERT_EQ(fault_of(good), std::nullopt);

  SensorReading old = good;
  old.age = units::Milliseconds(1'001);
  EXPECT_EQ(fault_of(old), Fault::sensor_stale);
  SensorReading swapped = good;
  std::swap(swapped.reference_low, swapped.reference_high);
  EXPECT_EQ(fault_of(swapped), Fault::sensor_implausible);
  SensorReading equal = good;
  equal.reference_low = equal.reference_high;
  EXPECT_EQ(fault_of(equal), Fault::sensor_implausible);
  SensorReading wrong_part = good;
  wrong_part.reference_high *= 2;
  EXPECT_EQ(fault_of(wrong_part), Fault::sensor_implausible);
  EXPECT_EQ(fault_of(SensorReading{.state = SensorState::ok}), Fault::sensor_implausible);
  // Beyond the ends of the table, also where the difference to the low reference is negative.
  EXPECT_EQ(fault_of(Circuit{}.reading(ntc_ohms(301))), Fault::sensor_implausible);
  EXPECT_EQ(fault_of(Circuit{}.reading(ntc_ohms(-11))), Fault::sensor_implausible);
  SensorReading extreme = good;
  extreme.thermistor = 0xFFFF'FFFF;
  EXPECT_EQ(fault_of(extreme), Fault::sensor_implausible);
}

TEST(sensor, gives_the_hardware_limits_that_hold_for_the_parts_as_they_are) {
  const Circuit circuit{.capacitor = 75e-9, .threshold = 0.6, .clock_hz = 4e6};
  const auto limits = sensor.limits(celsius(5), celsius(275), circuit.reading(ntc_ohms(25)));
  ASSERT_TRUE(limits);
  EXPECT_NEAR(
      measured({SensorState::ok, 0, limits->minimum, circuit.count(470), circuit.count(10e3), {}}),
      275, 1.0);
  EXPECT_LT(circuit.count(ntc_ohms(277)), limits->minimum);
  EXPECT_GT(circuit.count(ntc_ohms(273)), limits->minimum);
  EXPECT_GT(circuit.count(ntc_ohms(4)), limits->maximum);
  EXPECT_LT(circuit.count(ntc_ohms(6)), limits->maximum);
  EXPECT_FALSE(sensor.limits(celsius(5), celsius(275), {.state = SensorState::open}));
}

TEST(sensor, takes_no_thermistor_that_is_still_on_the_table_for_a_short) {
  const thermal::NominalCircuit circuit{tests::picoseconds_per_ohm, units::Hertz(4'000'000), 16, 2};
  const std::uint32_t limit = thermal::Sensor::short_limit(tests::ntc_table, circuit);
  const Circuit worst{.capacitor = 61e-9, .threshold = 0.4, .clock_hz = 4e6};
  EXPECT_LT(limit, worst.count(ntc_ohms(300)));
  EXPECT_GT(limit, worst.count(10));
}

}  // namespace
