// SPDX-License-Identifier: Apache-2.0
// A thermistor on a converter channel: from its newest conversion to a temperature or a
// named fault.
#include "thermal/sensor.hpp"

namespace thermal {
namespace {

// Of a state that is not ok; one without a name counts as no conversion.
Fault fault_of(SensorState state) {
  switch (state) {
    case SensorState::open:
      return Fault::sensor_open;
    case SensorState::shorted:
      return Fault::sensor_short;
    case SensorState::stuck:
      return Fault::sensor_stuck;
    case SensorState::time_out:
      return Fault::sensor_time_out;
    case SensorState::never:
    case SensorState::ok:
      break;
  }
  return Fault::sensor_stale;
}

}  // namespace

std::optional<units::Milliohms> Sensor::resistance_of(const SensorReading& reading) const {
  if (references_) return resistance(reading, *references_);
  return resistance(reading, circuit_);
}

Temperature Sensor::temperature(const SensorReading& reading) const {
  if (reading.state != SensorState::ok) return std::unexpected(fault_of(reading.state));
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
