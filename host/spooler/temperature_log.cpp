// SPDX-License-Identifier: Apache-2.0
// One sample for each interval.
#include "host/spooler/temperature_log.hpp"

#include <cmath>
#include <optional>

namespace spooler {

namespace {

nlohmann::json hundredths(const std::optional<double>& value) {
  return value ? nlohmann::json(std::round(*value * 100) / 100) : nlohmann::json();
}

}  // namespace

void TemperatureLog::take(const FeederState& state, std::int64_t time_ms) {
  if (state.link != "ready") return;
  heard_ms_ = time_ms;
  const bool set_back = time_ms < sampled_ms_;  // the clock
  if (!state.hotend || (!set_back && time_ms - sampled_ms_ < interval_ms)) return;
  if (set_back) samples_.clear();
  sampled_ms_ = time_ms;
  samples_.push_back({time_ms, hundredths(state.hotend), hundredths(state.hotend_target),
                      hundredths(state.hotend_power), hundredths(state.bed),
                      hundredths(state.bed_target), hundredths(state.bed_power)});
  if (samples_.size() > most_samples) samples_.pop_front();
}

nlohmann::json TemperatureLog::to_json() const {
  return {{"interval_ms", interval_ms}, {"samples", samples_}};
}

}  // namespace spooler
