// SPDX-License-Identifier: Apache-2.0
// A sensor channel outside the chip: capacitor, thermistor, two references, and the pins that
// charge it.
#pragma once

#include <cstdint>
#include <functional>
#include <random>

#include "sim/plants/thermistor.hpp"

namespace devices {

enum class Pull : std::uint8_t { none, up, down };

// The FPGA's own resistors at the pins, as its constraints set them.
struct SensorPulls {
  Pull resistor_pins = Pull::none;
  Pull sense_pin = Pull::none;
  double ohms = 110e3;  // the weakest of an ECP5, the hardest to notice; the strongest: 22 kOhm
};

struct ThermistorInputProperties {
  plants::Thermistor thermistor;
  double capacitor_farads{};  // as it is: with its deviation from the nominal value
  double leakage_ohms = 50e6;  // across the capacitor
  double reference_low_ohms{};
  double reference_high_ohms{};
  bool references = true;  // false: only the thermistor is wired
  double pin_ohms = 25;  // of each output, in series
  double supply_volts{};
  double threshold_volts{};
  double threshold_noise_volts = 2e-3;  // standard deviation, drawn for each charge
  SensorPulls pulls{};
};

enum class SensorFault : std::uint8_t { none, open, shorted, sense_stuck_high, sense_stuck_low };

// Bits of the pins, in `drive` and `level`: 0 thermistor, 1 low reference, 2 high reference. A pin
// that is not driven is high-impedance but for its pull. Between changes of the pins the voltage is
// an exponential, so the instant of the threshold is known when they change, and nothing needs to
// be computed until then.
class ThermistorInput {
 public:
  // `celsius` gives the temperature of the thermistor at a time in seconds.
  ThermistorInput(const ThermistorInputProperties& properties,
                  std::function<double(double)> celsius, std::uint64_t seed);

  // Times never go back.
  void set_pins(double seconds, std::uint8_t drive, std::uint8_t level);
  void set_fault(double seconds, SensorFault fault);
  // The capacitor has another value from now on, at the same voltage. One that is lost leaves what
  // pins and tracks have.
  void set_capacitor(double seconds, double farads);
  void scale_capacitor(double seconds, double factor);
  void lose_capacitor(double seconds) { set_capacitor(seconds, stray_farads); }

  // Whether the sense pin reads 1.
  bool sense(double seconds) const;
  // The next time at which sense() changes with the pins as they are; infinity for never.
  double next_change() const { return crossing_seconds_; }
  double volts(double seconds) const;

 private:
  static constexpr double stray_farads = 20e-12;
  // Norton's equivalent of what charges the capacitor.
  struct Charge {
    double siemens = 0;
    double amperes = 0;
    void add(double ohms, double volts);
  };
  double thermistor_ohms(double seconds);
  Charge charge(double seconds);
  void settle(double seconds);
  double noisy_threshold();

  ThermistorInputProperties properties_;
  std::function<double(double)> celsius_;
  std::mt19937_64 random_;
  SensorFault fault_ = SensorFault::none;
  std::uint8_t drive_ = 0;
  std::uint8_t level_ = 0;
  // The present exponential.
  double start_seconds_ = 0;
  double start_volts_ = 0;
  double final_volts_ = 0;
  double time_constant_ = 1;
  double threshold_ = 0;
  double crossing_seconds_;
  bool above_at_start_ = false;
  // The thermistor's temperature changes little within milliseconds.
  double ohms_ = 0;
  double ohms_until_seconds_ = -1;
};

}  // namespace devices
