// SPDX-License-Identifier: Apache-2.0
// The capacitor charges as the formula says, through whatever is connected to it.
#include "sim/devices/thermistor_input.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

constexpr double farads = 68e-9;
constexpr double forever = 1e30;

devices::ThermistorInputProperties ideal() {
  return {.thermistor = {100e3, 4066},
          .capacitor_farads = farads,
          .leakage_ohms = forever,
          .reference_low_ohms = 470,
          .reference_high_ohms = 10e3,
          .pin_ohms = 1e-9,
          .supply_volts = 3.3,
          .threshold_volts = 1.65,
          .threshold_noise_volts = 0};
}

// The time to the threshold after all was discharged for 10 ms.
double charge_time(devices::ThermistorInput& input, unsigned pin, double start) {
  input.set_pins(start, 7, 0);
  const auto only = static_cast<std::uint8_t>(1U << pin);
  input.set_pins(start + 0.01, only, only);
  EXPECT_FALSE(input.sense(start + 0.01));
  const double crossing = input.next_change();
  if (std::isfinite(crossing)) {
    EXPECT_FALSE(input.sense(crossing - 1e-9));
    EXPECT_TRUE(input.sense(crossing));
  }
  return crossing - start - 0.01;
}

TEST(thermistor_input, charges_in_the_time_constant_of_each_resistor) {
  devices::ThermistorInput input(ideal(), [](double) { return 25.0; }, 1);
  EXPECT_NEAR(charge_time(input, 1, 0), 470 * farads * std::log(2), 1e-9);
  EXPECT_NEAR(charge_time(input, 2, 1), 10e3 * farads * std::log(2), 1e-9);
  EXPECT_NEAR(charge_time(input, 0, 2), 100e3 * farads * std::log(2), 1e-9);
}

TEST(thermistor_input, charges_faster_through_a_hot_thermistor) {
  double celsius = 25;
  devices::ThermistorInput input(ideal(), [&celsius](double) { return celsius; }, 1);
  const double cold = charge_time(input, 0, 0);
  celsius = 200;
  EXPECT_NEAR(charge_time(input, 0, 1) / cold, std::exp(4066 * (1 / 473.15 - 1 / 298.15)), 1e-4);
}

TEST(thermistor_input, is_slowed_by_pin_resistance_and_by_leakage) {
  auto properties = ideal();
  properties.pin_ohms = 50;
  devices::ThermistorInput with_pin(properties, [](double) { return 200.0; }, 1);
  EXPECT_NEAR(charge_time(with_pin, 1, 0), 520 * farads * std::log(2), 1e-9);
  properties = ideal();
  properties.leakage_ohms = 150e3;
  devices::ThermistorInput leaky(properties, [](double) { return 25.0; }, 1);
  // Half the supply is 5/6 of what a divider of 100 and 150 kOhm can reach: tau ln 6 with 60 kOhm.
  EXPECT_NEAR(charge_time(leaky, 0, 0), 60e3 * farads * std::log(6), 1e-8);
}

TEST(thermistor_input, holds_its_charge_when_nothing_drives) {
  devices::ThermistorInput input(ideal(), [](double) { return 25.0; }, 1);
  charge_time(input, 1, 0);
  input.set_pins(0.02, 0, 0);
  EXPECT_TRUE(input.sense(5));
  EXPECT_EQ(input.next_change(), std::numeric_limits<double>::infinity());
}

TEST(thermistor_input, shows_its_faults) {
  auto properties = ideal();
  properties.pin_ohms = 25;
  devices::ThermistorInput input(properties, [](double) { return 25.0; }, 1);
  input.set_fault(0, devices::SensorFault::open);
  EXPECT_TRUE(std::isinf(charge_time(input, 0, 0)));
  EXPECT_NEAR(charge_time(input, 1, 1), 495 * farads * std::log(2), 1e-9);
  input.set_fault(2, devices::SensorFault::shorted);
  EXPECT_NEAR(charge_time(input, 0, 2), 25 * farads * std::log(2), 1e-9);
  input.set_fault(3, devices::SensorFault::sense_stuck_high);
  input.set_pins(3, 7, 0);
  EXPECT_TRUE(input.sense(4));
  input.set_fault(4, devices::SensorFault::sense_stuck_low);
  input.set_pins(4, 7, 7);
  EXPECT_FALSE(input.sense(5));
  EXPECT_TRUE(std::isinf(input.next_change()));
}

TEST(thermistor_input, is_charged_through_the_pulls_of_its_pins) {
  auto properties = ideal();
  properties.pulls = {.sense_pin = devices::Pull::up, .ohms = 22e3};
  devices::ThermistorInput pulled_sense(properties, [](double) { return 25.0; }, 1);
  pulled_sense.set_fault(0, devices::SensorFault::open);
  // Discharged through both references only, not wholly.
  const double references = 1 / (1 / 470.0 + 1 / 10e3);
  const double rest = 3.3 * references / (references + 22e3);
  EXPECT_NEAR(charge_time(pulled_sense, 0, 0), 22e3 * farads * std::log((3.3 - rest) / 1.65), 1e-8);
  // The pins of the references are open while the thermistor charges, and pull through them.
  properties.pulls = {.resistor_pins = devices::Pull::up, .ohms = 110e3};
  devices::ThermistorInput pulled_resistors(properties, [](double) { return 25.0; }, 1);
  pulled_resistors.set_fault(0, devices::SensorFault::open);
  const double ohms = 1 / (1 / 110.47e3 + 1 / 120e3);
  EXPECT_NEAR(charge_time(pulled_resistors, 0, 0), ohms * farads * std::log(2), 1e-8);
  // A pull to ground as strong as the thermistor keeps the threshold from being reached.
  properties.pulls = {.sense_pin = devices::Pull::down, .ohms = 100e3};
  devices::ThermistorInput held(properties, [](double) { return 24.0; }, 1);
  EXPECT_TRUE(std::isinf(charge_time(held, 0, 0)));
}

TEST(thermistor_input, is_noisy_and_yet_the_same_for_the_same_seed) {
  auto properties = ideal();
  properties.threshold_noise_volts = 5e-3;
  devices::ThermistorInput one(properties, [](double) { return 200.0; }, 7);
  devices::ThermistorInput same(properties, [](double) { return 200.0; }, 7);
  devices::ThermistorInput other(properties, [](double) { return 200.0; }, 8);
  double sum = 0, squares = 0;
  int different = 0;
  constexpr int charges = 2'000;
  for (int i = 0; i < charges; ++i) {
    const double time = charge_time(one, 0, i);
    EXPECT_EQ(time, charge_time(same, 0, i));
    different += time != charge_time(other, 0, i);
    sum += time;
    squares += time * time;
  }
  EXPECT_GT(different, charges - 10);
  const double mean = sum / charges;
  const double deviation = std::sqrt(squares / charges - mean * mean);
  // 5 mV at 1.65 V / (R C) per second.
  const double time_constant = mean / std::log(2);
  EXPECT_NEAR(deviation, 5e-3 / 1.65 * time_constant, 0.1 * 5e-3 / 1.65 * time_constant);
}

TEST(thermistor_input, follows_a_capacitor_that_changes_or_is_lost) {
  devices::ThermistorInput input(ideal(), [](double) { return 25.0; }, 1);
  const double whole = charge_time(input, 2, 0);
  input.scale_capacitor(1, 0.5);
  EXPECT_NEAR(charge_time(input, 2, 1) / whole, 0.5, 1e-6);
  input.scale_capacitor(2, 3);
  EXPECT_NEAR(charge_time(input, 2, 2) / whole, 1.5, 1e-6);
  // In the middle of charging the voltage stays, and the rest takes half as long.
  input.set_pins(3, 7, 0);
  input.set_pins(3.01, 4, 4);
  const double middle = 3.01 + whole / 2;
  const double rest = input.next_change() - middle;
  const double volts = input.volts(middle);
  input.scale_capacitor(middle, 0.5);
  EXPECT_NEAR(input.volts(middle), volts, 1e-9);
  EXPECT_NEAR((input.next_change() - middle) / rest, 0.5, 1e-6);
  input.lose_capacitor(4);
  EXPECT_LT(charge_time(input, 2, 4), whole / 1000);
}

}  // namespace
