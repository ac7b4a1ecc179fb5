// SPDX-License-Identifier: Apache-2.0
// From charge times to the resistance of the thermistor, and back to the counts at a resistance.
#pragma once

#include <cstdint>
#include <optional>

#include "thermal/elementary_functions.hpp"
#include "thermal/sensor_reading.hpp"
#include "units/quantity.hpp"

namespace thermal {

struct ReferenceResistors {
  units::Milliohms low{};
  units::Milliohms high{};
};

// The wiring without references: the time is converted with nominal values.
struct NominalCircuit {
  // Time to the pin's threshold per ohm: capacitor * ln(V / (V - Vt)).
  std::uint32_t picoseconds_per_ohm{};
  units::Hertz clock{};
  std::uint32_t charges{};  // per conversion
  std::uint32_t delay_cycles{};  // that the hardware counts too many per charge
};

// Capacitor in picofarads, voltages in any one unit.
consteval std::uint32_t picoseconds_per_ohm(double capacitor_pf, double supply, double threshold) {
  return static_cast<std::uint32_t>(capacitor_pf * logarithm(supply / (supply - threshold)) + 0.5);
}

// Three times t of one capacitor to one threshold: R = low + (t - t_low) / (t_high - t_low) (high -
// low). Capacitor, threshold, supply, the pins' own resistance and constant delays cancel. Nothing
// where the reference times do not fit their resistors, allowing for up to 150 ohms in each pin.
std::optional<units::Milliohms> resistance(const SensorReading& reading,
                                           const ReferenceResistors& references);

// From the thermistor's time alone.
units::Milliohms resistance(const SensorReading& reading, const NominalCircuit& circuit);

// The thermistor count that a resistance would give, with this capacitor, threshold and pin.
// Nothing as above.
std::optional<std::uint32_t> count_at(units::Milliohms resistance, const SensorReading& reading,
                                      const ReferenceResistors& references);
std::uint32_t count_at(units::Milliohms resistance, const NominalCircuit& circuit);

}  // namespace thermal
