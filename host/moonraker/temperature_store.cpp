// SPDX-License-Identifier: Apache-2.0
// Rings of samples.
#include "host/moonraker/temperature_store.hpp"

namespace moonraker {

void TemperatureStore::sample(const nlohmann::json& objects) {
  const std::scoped_lock lock(mutex_);
  for (const char* name : {"extruder", "heater_bed"}) {
    const auto& heater = objects.at(name);
    if (!heater.contains("temperature")) continue;
    Series& series = heaters_[name];
    const auto add = [&](std::deque<double>& values, const char* field) {
      values.push_back(heater.value(field, 0.0));
      if (values.size() > longest) values.pop_front();
    };
    add(series.temperatures, "temperature");
    add(series.targets, "target");
    if (heater.contains("power")) add(series.powers, "power");
  }
}

nlohmann::json TemperatureStore::stored() const {
  const std::scoped_lock lock(mutex_);
  nlohmann::json all = nlohmann::json::object();
  for (const auto& [name, series] : heaters_) {
    all[name] = {{"temperatures", series.temperatures}, {"targets", series.targets}};
    if (!series.powers.empty()) all[name]["powers"] = series.powers;
  }
  return all;
}

}  // namespace moonraker
