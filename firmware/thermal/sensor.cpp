// SPDX-License-Identifier: Apache-2.0
// A thermistor on a converter channel: from its newest conversion to a temperature or a named
// fault.
#include "thermal/sensor.hpp"

namespace thermal {

std::optional<units::Milliohms> Sensor::resistance_of(const SensorReading& reading) const {
  if (references_) return resistance(reading, *references_);
  return resistance(reading, circuit_);
}

Temperature Sensor::temperature(const SensorReading& reading) const {
  switch (reading.state) {
    case SensorState::never:
      return std::unexpected(Fault::sensor_stale);
    case SensorState::open:
      return std::unexpected(Fault::sensor_open);
    case SensorState::shorted:
      return std::unexpected(Fault::sensor_short);
    case SensorState::stuck:
      return std::unexpected(Fault::sensor_stuck);
    case SensorState::time_out:
      return std::unexpected(Fault::sensor_time_out);
    case SensorState::ok:
      break;
  }
  if (reading.age > longest_age) return std::unexpected(Fault::sensor_stale);
  const auto milliohms = resistance_of(reading);
  if (!milliohms) return std::unexpected(Fault::sensor_implausible);
  const auto found = table_.temperature(*milliohms);
  if (!found) return std::unexpected(Fault::sensor_implausible);
  return *found;
}

std::optional<CountLimits> Sensor::limits(units::Millicelsius minimum, units::Millicelsius maximum,
                                          const SensorReading& reading) const {
  const auto cold = table_.resistance(minimum);
  const auto hot = table_.resistance(maximum);
  if (!references_) return CountLimits{count_at(hot, circuit_), count_at(cold, circuit_)};
  if (!temperature(reading)) return std::nullopt;
  return CountLimits{*count_at(hot, reading, *references_), *count_at(cold, reading, *references_)};
}

std::uint32_t Sensor::short_limit(const ThermistorTable& table, const NominalCircuit& circuit) {
  // Half of it: capacitor and threshold are not known yet.
  return count_at(table.resistance(ThermistorTable::highest) / 2, circuit);
}

}  // namespace thermal
