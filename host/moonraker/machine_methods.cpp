// SPDX-License-Identifier: Apache-2.0
// machine: what the machine is and does. It is neither updated nor switched off from here.
#include "host/moonraker/core.hpp"
#include "host/moonraker/machine.hpp"
#include "host/moonraker/method_tables.hpp"

namespace moonraker {

namespace {

Json info(Core&, const Json&, Connection*) { return {{"system_info", system_info()}}; }

Json stats(Core& core, const Json&, Connection*) {
  ProcessorTime none;
  Json json = process_stats(none, core.hub.size());
  json["moonraker_stats"] = Json::array({json.at("moonraker_stats")});
  json["throttled_state"] = {{"bits", 0}, {"flags", Json::array()}};
  json["system_uptime"] = event_time();
  return json;
}

Json updates(Core&, const Json&, Connection*) {
  return {{"busy", false},
          {"github_rate_limit", 0},
          {"github_requests_remaining", 0},
          {"github_limit_reset_time", 0},
          {"version_info", Json::object()}};
}

Json no_devices(Core&, const Json&, Connection*) { return {{"devices", Json::array()}}; }

Json refuse(Core&, const Json&, Connection*) {
  throw Error(403, "the machine is not switched, and nothing on it is restarted, from here");
}

}  // namespace

std::vector<Method> machine_methods() {
  return {{"machine.system_info", "GET", "/machine/system_info", info},
          {"machine.proc_stats", "GET", "/machine/proc_stats", stats},
          {"machine.update.status", "GET", "/machine/update/status", updates},
          {"machine.update.refresh", "POST", "/machine/update/refresh", updates},
          {"machine.device_power.devices", "GET", "/machine/device_power/devices", no_devices},
          {"machine.shutdown", "POST", "/machine/shutdown", refuse},
          {"machine.reboot", "POST", "/machine/reboot", refuse},
          {"machine.services.restart", "POST", "/machine/services/restart", refuse},
          {"machine.services.start", "POST", "/machine/services/start", refuse},
          {"machine.services.stop", "POST", "/machine/services/stop", refuse}};
}

}  // namespace moonraker
