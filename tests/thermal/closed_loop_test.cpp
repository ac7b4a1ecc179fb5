// SPDX-License-Identifier: Apache-2.0
// The firmware's thermal logic holds the simulated hotend and bed, measured as coarsely as the
// clock allows.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "sim/devices/thermistor_input.hpp"
#include "sim/machine/thermal_properties.hpp"
#include "tests/thermal/ntc.hpp"
#include "thermal/heater_loop.hpp"

namespace {

using tests::celsius;
using units::Milliseconds;

constexpr double period = 0.1;
constexpr double slot = 0.005;  // of the pulse-density modulation
constexpr double fan_mean = 0.6;

struct Course {
  double arrived = -1;  // s
  double highest = -300;
  double band = 0;  // largest distance from the target after the arrival
  std::optional<thermal::Fault> fault;
};

// Converter, sensor, loop, gate and plant as on the chip, with time in steps of a slot.
class Bench {
 public:
  Bench(const plants::HeatedBlockProperties& properties, const thermal::HeaterSettings& settings,
        double clock_hz, std::uint64_t seed)
      : block(properties, machine::ambient_celsius, machine::ambient_celsius),
        loop(settings),
        clock_hz_(clock_hz),
        input_(
            {.thermistor = {100e3, 4066},
             .capacitor_farads = 68e-9 * 1.08,
             .reference_low_ohms = 470,
             .reference_high_ohms = 10e3,
             .supply_volts = 3.3,
             .threshold_volts = 1.5},
            [this](double) { return block.sensor_celsius(now_); }, seed) {}

  // `disturb` is called every period with the time since the arrival, or a negative one before.
  template <class Disturb>
  Course run(double target, double seconds, Disturb disturb) {
    Course course;
    loop.set_target(celsius(target));
    const double end = now_ + seconds;
    while (now_ < end) {
      const thermal::Duty duty =
          loop.update(sensor_.temperature(convert()), Milliseconds(std::llround(now_ * 1000)));
      disturb(course.arrived < 0 ? -1 : now_ - course.arrived);
      heat(duty);
      const double block_celsius = block.celsius(now_);
      course.highest = std::max(course.highest, block_celsius);
      if (course.arrived < 0 && loop.at_target()) course.arrived = now_;
      if (course.arrived >= 0) {
        course.band = std::max(course.band, std::abs(block_celsius - target));
      }
      if ((course.fault = loop.fault())) break;
    }
    return course;
  }

  plants::HeatedBlock block;
  thermal::HeaterLoop loop;
  double now() const { return now_; }

 private:
  // Sixteen dithered charges; their time does not count here, for the temperature changes little in
  // it.
  std::uint32_t count(unsigned pin) {
    std::uint32_t sum = 0;
    for (int charge = 0; charge < 16; ++charge) {
      wait_cycles(std::ceil(400e-6 * clock_hz_), 7, 0);
      if (charge > 0) wait_cycles(charge, 4, 4);
      const auto only = static_cast<std::uint8_t>(1U << pin);
      input_.set_pins(cycles_ / clock_hz_, only, only);
      const double until = std::ceil(input_.next_change() * clock_hz_) + 2;
      sum += static_cast<std::uint32_t>(until - cycles_);
      cycles_ = until;
    }
    return sum;
  }
  void wait_cycles(double cycles, std::uint8_t drive, std::uint8_t level) {
    input_.set_pins(cycles_ / clock_hz_, drive, level);
    cycles_ += cycles;
  }
  thermal::SensorReading convert() {
    thermal::SensorReading reading{.state = thermal::SensorState::ok};
    reading.reference_low = count(1);
    reading.reference_high = count(2);
    reading.thermistor = count(0);
    return reading;
  }
  void heat(thermal::Duty duty) {
    for (int i = 0; i < std::lround(period / slot); ++i) {
      density_ += duty;
      const bool on = density_ >= thermal::full_duty;
      if (on) density_ -= thermal::full_duty;
      block.set_heater(now_, on);
      now_ += slot;
    }
  }

  thermal::Sensor sensor_{tests::ntc_table, tests::references};
  double clock_hz_;
  double now_ = 0;
  double cycles_ = 0;
  std::uint32_t density_ = 0;
  devices::ThermistorInput input_;
};

// As in firmware/machines/prusa_mendel.toml.
thermal::HeaterSettings hotend_settings() {
  thermal::HeaterSettings settings;
  settings.maximum = celsius(275);
  settings.gains = {9'830, 524, 58'982, 98};
  return settings;
}

thermal::HeaterSettings bed_settings() {
  thermal::HeaterSettings settings;
  settings.maximum = celsius(120);
  settings.gains = {13'107, 98, 98'303, 590};
  settings.protection.watch_period = Milliseconds(60'000);
  return settings;
}

class ClosedLoop : public testing::TestWithParam<double> {};

TEST_P(ClosedLoop, hotend_overshoots_less_than_five_degrees_and_stays_within_two_while_printing) {
  for (const double target : {185.0, 205.0, 250.0}) {
    Bench bench(machine::hotend_properties(40), hotend_settings(), GetParam(), 1);
    const Course course = bench.run(target, 400, [&bench](double printing) {
      if (printing < 0) return;
      // After 30 s the fan comes on, later it goes up and down; filament comes in fits and starts.
      const double now = bench.now();
      const double second = std::floor(printing);
      bench.block.set_fan(now, second < 30                  ? 0
                               : second < 120               ? fan_mean
                               : std::fmod(second, 40) < 20 ? 1
                                                            : 0.3);
      bench.block.set_extrusion(now, std::fmod(second, 7) < 5 ? 4.0 : 0.0);
    });
    EXPECT_EQ(course.fault, std::nullopt);
    EXPECT_GT(course.arrived, 0);
    EXPECT_LT(course.arrived, 200);
    EXPECT_LT(course.highest, target + 5);
    EXPECT_LT(course.band, 2.0) << target;
    RecordProperty("band_at_" + std::to_string(static_cast<int>(target)),
                   std::to_string(course.band));
  }
}

TEST_P(ClosedLoop, bed_stays_within_one_degree) {
  for (const double target : {60.0, 100.0}) {
    Bench bench(machine::bed_properties(120), bed_settings(), GetParam(), 2);
    const Course course = bench.run(target, 1'500, [](double) {});
    EXPECT_EQ(course.fault, std::nullopt);
    EXPECT_GT(course.arrived, 0);
    EXPECT_LT(course.highest, target + 2);
    EXPECT_LT(course.band, 1.0);
  }
}

TEST_P(ClosedLoop, follows_a_change_of_the_target_in_both_directions) {
  Bench bench(machine::hotend_properties(40), hotend_settings(), GetParam(), 3);
  EXPECT_LT(bench.run(205, 200, [](double) {}).band, 2.0);
  EXPECT_LT(bench.run(190, 200, [](double) {}).band, 2.0);
  const Course up = bench.run(220, 200, [](double) {});
  EXPECT_LT(up.highest, 225);
  EXPECT_LT(up.band, 2.0);
}

INSTANTIATE_TEST_SUITE_P(at, ClosedLoop, testing::Values(4e6, 8e6, 50e6), [](const auto& clock) {
  return std::to_string(static_cast<int>(clock.param / 1e6)) + "_mhz";
});

TEST(closed_loop, finds_a_heater_that_fails_while_printing) {
  Bench bench(machine::hotend_properties(40), hotend_settings(), 8e6, 4);
  const Course course = bench.run(205, 500, [&bench](double printing) {
    if (printing > 20) bench.block.set_fault(bench.now(), plants::HeaterFault::stuck_off);
  });
  EXPECT_EQ(course.fault, thermal::Fault::thermal_runaway);
}

TEST(closed_loop, finds_a_heater_that_sticks_before_it_is_dangerous) {
  Bench bench(machine::hotend_properties(40), hotend_settings(), 8e6, 5);
  const Course course = bench.run(205, 500, [&bench](double printing) {
    if (printing > 20) bench.block.set_fault(bench.now(), plants::HeaterFault::stuck_on);
  });
  EXPECT_EQ(course.fault, thermal::Fault::unasked_heat);
  EXPECT_LT(course.highest, 260);
}

}  // namespace
