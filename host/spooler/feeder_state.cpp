// SPDX-License-Identifier: Apache-2.0
// Reads a feeder's message.
#include "host/spooler/feeder_state.hpp"

namespace spooler {

namespace {

std::optional<double> number(const nlohmann::json& value) {
  if (value.is_null()) return std::nullopt;
  return value.get<double>();
}

// A feeder of an earlier version that goes on printing says none.
std::optional<double> power(const nlohmann::json& heater) {
  return heater.size() > 2 ? number(heater.at(2)) : std::nullopt;
}

}  // namespace

FeederState feeder_state_of(const nlohmann::json& message) {
  FeederState state{.link = message.at("link"),
                    .job = std::nullopt,
                    .phase = message.value("phase", ""),
                    .why = message.value("why", ""),
                    .fault = message.value("fault", ""),
                    .done = message.value("done", std::int64_t{}),
                    .commands = message.value("commands", std::int64_t{}),
                    .waits_for_user = message.at("waits_for_user"),
                    .hotend_to_restore = message.value("hotend_to_restore", 0.0),
                    .resends = message.at("resends"),
                    .homed = message.value("homed", ""),
                    .hotend = number(message.at("hotend").at(0)),
                    .hotend_target = number(message.at("hotend").at(1)),
                    .hotend_power = power(message.at("hotend")),
                    .bed = number(message.at("bed").at(0)),
                    .bed_target = number(message.at("bed").at(1)),
                    .bed_power = power(message.at("bed")),
                    .position = message.value("position", nlohmann::json())};
  if (message.contains("job")) state.job = message.at("job").get<std::int64_t>();
  return state;
}

bool is_over(const FeederState& state) {
  return state.phase == "finished" || state.phase == "cancelled" || state.phase == "failed" ||
         state.phase == "interrupted";
}

}  // namespace spooler
