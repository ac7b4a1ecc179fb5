// SPDX-License-Identifier: Apache-2.0
// Converter, sensor, loop, gate and plant as on the chip: the firmware's thermal logic holds a
// simulated hotend or bed, measured as coarsely as the clock allows.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "machine/machine.hpp"
#include "sim/devices/thermistor_input.hpp"
#include "sim/machine/surroundings.hpp"
#include "tests/plants/described_heaters.hpp"
#include "tests/thermal/ntc.hpp"
#include "thermal/heater_loop.hpp"

namespace tests {

inline constexpr double period = 0.1;
inline constexpr double slot = 0.005;  // of the pulse-density modulation

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
        double clock_hz, std::uint64_t seed, double start = machine::ambient_celsius)
      : block(properties, machine::ambient_celsius, start),
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

  // `disturb` is called every period with the time since the arrival, or a negative one before; it
  // may return false to end the run.
  template <class Disturb>
  Course run(double target, double seconds, Disturb disturb) {
    Course course;
    loop.set_target(celsius(target));
    const double end = now_ + seconds;
    while (now_ < end) {
      const thermal::Duty duty = loop.update(sensor_.temperature(convert()),
                                             units::Milliseconds(std::llround(now_ * 1000)));
      const double held = course.arrived < 0 ? -1 : now_ - course.arrived;
      if constexpr (std::is_void_v<decltype(disturb(held))>) {
        disturb(held);
      } else if (!disturb(held)) {
        break;
      }
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
  // Sixteen dithered charges; their time does not count here, for the temperature changes
  // little in it.
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
inline thermal::HeaterSettings hotend_settings() {
  thermal::HeaterSettings settings;
  settings.maximum = celsius(275);
  settings.gains = {9'830, 524, 58'982, 98};
  settings.model = &machine::machine.hotend.model;
  return settings;
}

inline thermal::HeaterSettings bed_settings() {
  thermal::HeaterSettings settings;
  settings.maximum = celsius(120);
  settings.gains = {13'107, 98, 98'303, 590};
  settings.model = &machine::machine.bed.model;
  settings.protection.watch_period = units::Milliseconds(60'000);
  return settings;
}

}  // namespace tests
