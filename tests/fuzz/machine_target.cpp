// SPDX-License-Identifier: Apache-2.0
// Machine descriptions: each is refused with file, line and reason, or is one that both the
// firmware and the simulated printer can be made of.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <set>
#include <stdexcept>
#include <string>

#include "sim/machine/description.hpp"
#include "sim/simulation/pins.hpp"
#include "tests/fuzz/property.hpp"
#include "tools/machine_generator/reader.hpp"

namespace {

constexpr std::string_view name = "machine.toml";

bool positive(double value) { return std::isfinite(value) && value > 0; }
bool not_negative(double value) { return std::isfinite(value) && value >= 0; }

void require_line(std::string_view message, std::string_view text) {
  const std::string begin = std::string(name) + ": line ";
  fuzz::require(message.starts_with(begin), "a refusal names no line: {}", message);
  message.remove_prefix(begin.size());
  long line = 0;
  const auto end = std::from_chars(message.data(), message.data() + message.size(), line);
  fuzz::require(std::string_view(end.ptr, 2) == ": ", "a refusal names no line: {}", message);
  fuzz::require(line >= 0 && line <= std::ranges::count(text, '\n') + 2,
                "a refusal names line {}, which there is not", line);
}

void require_a_heater(const machine::HeaterDescription& heater) {
  const auto& path = heater.block.path;
  fuzz::require(
      heater.heater_channel < sim::heater_count && heater.sensor_channel < sim::sensor_count,
      "channels {} and {} are none of the chip", heater.heater_channel, heater.sensor_channel);
  fuzz::require(positive(heater.block.heater_watts) && std::isfinite(heater.max_c) &&
                    positive(heater.resistance_25c_ohms) && positive(heater.beta_k),
                "a heater without power or thermistor");
  fuzz::require(positive(path.heater_joules_per_kelvin) && positive(path.block_joules_per_kelvin) &&
                    positive(path.heater_to_block_watts_per_kelvin) &&
                    positive(path.sensor_lag_seconds) &&
                    not_negative(heater.block.loss_watts_per_kelvin) &&
                    not_negative(heater.block.fan_loss_watts_per_kelvin),
                "a heater that cannot be computed");
}

void require_a_machine(const machine::Description& description) {
  fuzz::require(description.baud > 0, "a serial line without a speed");
  std::set<std::size_t> end_stops;
  for (const auto& axis : description.axes) {
    fuzz::require(positive(axis.steps_per_mm) && positive(axis.max_speed_mm_s) &&
                      positive(axis.max_acceleration_mm_s2) && not_negative(axis.jerk_mm_s),
                  "an axis that cannot move");
    fuzz::require(!axis.travel_mm || positive(*axis.travel_mm), "an axis without travel");
    if (!axis.end_stop) continue;
    fuzz::require(*axis.end_stop < sim::end_stop_count, "an end stop that the chip does not have");
    fuzz::require(end_stops.insert(*axis.end_stop).second, "an end stop of two axes");
  }
  require_a_heater(description.hotend);
  require_a_heater(description.bed);
  fuzz::require(description.hotend.heater_channel != description.bed.heater_channel &&
                    description.hotend.sensor_channel != description.bed.sensor_channel,
                "a channel of two heaters");
  const auto& converter = description.converter;
  fuzz::require(positive(converter.capacitor_nf) && positive(converter.reference_low_ohms) &&
                    converter.reference_high_ohms > converter.reference_low_ohms &&
                    positive(converter.threshold_v) && converter.supply_v > converter.threshold_v,
                "a converter that cannot measure");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    require_a_machine(machine::parse_description(text, name));
  } catch (const machine_generator::DescriptionError& error) {
    require_line(error.what(), text);
  }
  return 0;
}
