// SPDX-License-Identifier: Apache-2.0
// From charge times to the resistance of the thermistor, and back to the counts at a resistance.
#include "thermal/resistance.hpp"

#include <algorithm>
#include <limits>

namespace thermal {
namespace {

constexpr std::int64_t largest_pin_milliohms = 150'000;

// (t_high + r) / (t_low + r) of resistors in series with a pin of r falls as r grows; so a ratio of
// times beyond its values at no pin and at the largest pin (with 5 % for the parts) is not theirs.
bool fit_their_resistors(const SensorReading& reading, const ReferenceResistors& references) {
  const std::int64_t low = reading.reference_low;
  const std::int64_t high = reading.reference_high;
  if (low <= 0 || high <= low) return false;
  // Times are up to 2^30 and resistances up to 2^24 mOhm.
  const std::int64_t steepest = high * references.low.count() / 105 * 100;
  const std::int64_t flattest = high * (references.low.count() + largest_pin_milliohms) / 100 * 105;
  return steepest <= low * references.high.count() &&
         flattest >= low * (references.high.count() + largest_pin_milliohms);
}

std::uint32_t to_count(std::int64_t value) {
  return static_cast<std::uint32_t>(
      std::clamp<std::int64_t>(value, 0, std::numeric_limits<std::uint32_t>::max()));
}

}  // namespace

std::optional<units::Milliohms> resistance(const SensorReading& reading,
                                           const ReferenceResistors& references) {
  if (!fit_their_resistors(reading, references)) return std::nullopt;
  const std::int64_t above_low = std::int64_t{reading.thermistor} - reading.reference_low;
  const std::int64_t span = std::int64_t{reading.reference_high} - reading.reference_low;
  return references.low +
         units::Milliohms((references.high - references.low).count() * above_low / span);
}

units::Milliohms resistance(const SensorReading& reading, const NominalCircuit& circuit) {
  const std::int64_t cycles =
      std::int64_t{reading.thermistor} - std::int64_t{circuit.delay_cycles} * circuit.charges;
  const std::int64_t charges_per_second = std::int64_t{circuit.charges} * circuit.clock.count();
  const std::int64_t nanoseconds = cycles * 1'000'000'000 / charges_per_second;
  return units::Milliohms(nanoseconds * 1'000'000 / circuit.picoseconds_per_ohm);
}

std::optional<std::uint32_t> count_at(units::Milliohms resistance, const SensorReading& reading,
                                      const ReferenceResistors& references) {
  if (!fit_their_resistors(reading, references)) return std::nullopt;
  const std::int64_t span = std::int64_t{reading.reference_high} - reading.reference_low;
  const std::int64_t above_low = (resistance - references.low).count();
  return to_count(reading.reference_low +
                  above_low * span / (references.high - references.low).count());
}

std::uint32_t count_at(units::Milliohms resistance, const NominalCircuit& circuit) {
  const std::int64_t nanoseconds = resistance.count() * circuit.picoseconds_per_ohm / 1'000'000;
  const std::int64_t cycles_per_charge =
      nanoseconds * (circuit.clock.count() / 1'000) / 1'000'000 + circuit.delay_cycles;
  return to_count(cycles_per_charge * circuit.charges);
}

}  // namespace thermal
