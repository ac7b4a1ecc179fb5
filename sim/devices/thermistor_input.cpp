// SPDX-License-Identifier: Apache-2.0
// A sensor channel outside the chip: capacitor, thermistor, two references, and the pins that
// charge it.
#include "sim/devices/thermistor_input.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace devices {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();
// No wait is longer: a threshold that a mere leakage reaches in years is not reached.
constexpr double longest_delay_seconds = 1e6;
constexpr double temperature_refresh_seconds = 0.005;

// Two draws of the generator give one normal deviate (Box and Muller, 1958): unlike
// std::normal_distribution the same on every library.
double normal_deviate(std::mt19937_64& random) {
  constexpr double scale = 0x1p-53;
  const double radius = 1.0 - static_cast<double>(random() >> 11) * scale;
  const double angle = 2.0 * std::numbers::pi * static_cast<double>(random() >> 11) * scale;
  return std::sqrt(-2.0 * std::log(radius)) * std::cos(angle);
}

}  // namespace

ThermistorInput::ThermistorInput(const ThermistorInputProperties& properties,
                                 std::function<double(double)> celsius, std::uint64_t seed)
    : properties_(properties),
      celsius_(std::move(celsius)),
      random_(seed),
      crossing_seconds_(never) {
  if (!(properties.capacitor_farads > 0 && properties.leakage_ohms > 0 && properties.pin_ohms > 0 &&
        properties.pulls.ohms > 0 && properties.threshold_volts > 0 &&
        properties.threshold_volts < properties.supply_volts)) {
    throw std::invalid_argument(
        "a thermistor input needs parts above 0 and a threshold within the supply");
  }
  settle(0);
}

void ThermistorInput::set_pins(double seconds, std::uint8_t drive, std::uint8_t level) {
  if (drive == drive_ && (level & drive) == (level_ & drive_)) return;
  start_volts_ = volts(seconds);
  drive_ = drive;
  level_ = level;
  settle(seconds);
}

void ThermistorInput::set_fault(double seconds, SensorFault fault) {
  start_volts_ = volts(seconds);
  fault_ = fault;
  settle(seconds);
}

void ThermistorInput::set_capacitor(double seconds, double farads) {
  start_volts_ = volts(seconds);
  properties_.capacitor_farads = farads;
  settle(seconds);
}

void ThermistorInput::scale_capacitor(double seconds, double factor) {
  set_capacitor(seconds, properties_.capacitor_farads * factor);
}

double ThermistorInput::volts(double seconds) const {
  return final_volts_ +
         (start_volts_ - final_volts_) * std::exp(-(seconds - start_seconds_) / time_constant_);
}

bool ThermistorInput::sense(double seconds) const {
  if (fault_ == SensorFault::sense_stuck_high) return true;
  if (fault_ == SensorFault::sense_stuck_low) return false;
  return above_at_start_ != (seconds >= crossing_seconds_);
}

double ThermistorInput::thermistor_ohms(double seconds) {
  if (fault_ == SensorFault::open) return never;
  if (fault_ == SensorFault::shorted) return 0;
  if (seconds >= ohms_until_seconds_) {
    ohms_ = properties_.thermistor.ohms(celsius_(seconds));
    ohms_until_seconds_ = seconds + temperature_refresh_seconds;
  }
  return ohms_;
}

double ThermistorInput::noisy_threshold() {
  return properties_.threshold_volts + properties_.threshold_noise_volts * normal_deviate(random_);
}

void ThermistorInput::Charge::add(double ohms, double volts) {
  siemens += 1.0 / ohms;
  amperes += 1.0 / ohms * volts;
}

// All driven pins, pulls, and the leakage. The pull of a driven pin is left
// out: it adds a thousandth to the pin's own resistance.
ThermistorInput::Charge ThermistorInput::charge(double seconds) {
  const double reference_low = properties_.references ? properties_.reference_low_ohms : never;
  const double reference_high = properties_.references ? properties_.reference_high_ohms : never;
  const std::array<double, 3> ohms{thermistor_ohms(seconds), reference_low, reference_high};
  const SensorPulls& pulls = properties_.pulls;
  const auto volts = [this](bool up) { return up ? properties_.supply_volts : 0.0; };
  Charge charge;
  charge.add(properties_.leakage_ohms, 0);
  if (pulls.sense_pin != Pull::none) charge.add(pulls.ohms, volts(pulls.sense_pin == Pull::up));
  for (unsigned pin = 0; pin < ohms.size(); ++pin) {
    if ((drive_ >> pin & 1) != 0) {
      charge.add(ohms[pin] + properties_.pin_ohms, volts((level_ >> pin & 1) != 0));
    } else if (pulls.resistor_pins != Pull::none) {
      charge.add(ohms[pin] + pulls.ohms, volts(pulls.resistor_pins == Pull::up));
    }
  }
  return charge;
}

// The capacitor charges as `charge` says from here on.
void ThermistorInput::settle(double seconds) {
  const Charge now = charge(seconds);
  start_seconds_ = seconds;
  final_volts_ = now.amperes / now.siemens;
  time_constant_ = properties_.capacitor_farads / now.siemens;
  threshold_ = noisy_threshold();
  above_at_start_ = start_volts_ > threshold_;
  crossing_seconds_ = never;
  if (fault_ == SensorFault::sense_stuck_high || fault_ == SensorFault::sense_stuck_low) return;
  if (above_at_start_ != (final_volts_ > threshold_)) {
    const double delay =
        time_constant_ * std::log((start_volts_ - final_volts_) / (threshold_ - final_volts_));
    if (delay < longest_delay_seconds) crossing_seconds_ = seconds + delay;
  }
}

}  // namespace devices
