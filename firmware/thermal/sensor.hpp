// SPDX-License-Identifier: Apache-2.0
// A thermistor on a converter channel: from its newest conversion to a temperature or
// a named fault.
#pragma once

#include <expected>
#include <optional>

#include "thermal/fault.hpp"
#include "thermal/resistance.hpp"
#include "thermal/sensor_reading.hpp"
#include "thermal/thermistor_table.hpp"

namespace thermal {

using Temperature = std::expected<units::Millicelsius, Fault>;

class Sensor {
 public:
  // The table must outlive the sensor.
  constexpr Sensor(const ThermistorTable& table, const ReferenceResistors& references)
      : table_(table), references_(references) {}
  constexpr Sensor(const ThermistorTable& table, const NominalCircuit& circuit)
      : table_(table), circuit_(circuit) {}

  // A conversion older than this is not used.
  static constexpr units::Milliseconds longest_age{1'000};

  Temperature temperature(const SensorReading& reading) const;

  // The counts at two temperatures, for the limits in hardware. With references they take the
  // capacitor and the threshold as they are, so the reading must be ok.
  std::optional<CountLimits> limits(units::Millicelsius minimum, units::Millicelsius maximum,
                                    const SensorReading& reading) const;

  // The count at the end of the table, below which the thermistor must be shorted,
  // with nominal parts.
  static std::uint32_t short_limit(const ThermistorTable& table, const NominalCircuit& circuit);

 private:
  std::optional<units::Milliohms> resistance_of(const SensorReading& reading) const;

  const ThermistorTable& table_;
  std::optional<ReferenceResistors> references_;
  NominalCircuit circuit_{};
};

}  // namespace thermal
