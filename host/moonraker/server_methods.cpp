// SPDX-License-Identifier: Apache-2.0
// server: who is there, and what was said and measured.
#include <algorithm>
#include <chrono>

#include "host/moonraker/core.hpp"
#include "host/moonraker/method_tables.hpp"
#include "host/moonraker/versions.hpp"

namespace moonraker {

namespace {

Json info(Core& core, const Json&, Connection*) {
  const std::string_view state = core.view().klippy_state();
  return {{"klippy_connected", state != "disconnected"},
          {"klippy_state", state},
          {"components",
           {"server", "file_manager", "klippy_apis", "database", "machine", "data_store",
            "proc_stats", "job_queue", "history", "authorization", "announcements", "webcam"}},
          {"failed_components", Json::array()},
          {"registered_directories", {"gcodes"}},
          {"warnings", Json::array()},
          {"missing_klippy_requirements", Json::array()},
          {"websocket_count", core.hub.size()},
          {"moonraker_version", moonraker_version},
          {"api_version", api_version},
          {"api_version_string", api_version_text}};
}

Json config(Core& core, const Json&, Connection*) {
  const Json sections{{"server", Json::object()},
                      {"data_store", {{"temperature_store_size", TemperatureStore::longest}}},
                      {"file_manager", {{"queue_gcode_uploads", true}}},
                      {"job_queue", {{"load_on_startup", true}, {"automatic_transition", true}}},
                      {"authorization", {{"force_logins", core.access.needs_key()}}}};
  return {{"config", sections}, {"orig", Json::object()}, {"files", Json::array()}};
}

Json identify(Core& core, const Json& params, Connection* connection) {
  if (connection == nullptr) throw Error(400, "only a WebSocket is identified");
  for (const char* name : {"client_name", "version", "type", "url"}) text_in(params, name);
  for (const char* name : {"api_key", "access_token"}) {
    const std::string given = text_in(params, name, "");
    if (given.empty()) continue;
    if (!core.access.is_good(given)) refuse_key(core, connection, "Unauthorized: the key is wrong");
    connection->authorise();
  }
  if (!connection->is_authorised()) throw Error(401, "Unauthorized: the key is missing");
  return {{"connection_id", connection->id()}};
}

Json number(Core&, const Json&, Connection* connection) {
  if (connection == nullptr) throw Error(400, "only a WebSocket has a number");
  return {{"websocket_id", connection->id()}};
}

Json console(Core& core, const Json& params, Connection*) {
  const PrinterView view = core.view();
  const Json& lines = view.printer().at("console");
  const auto size = static_cast<std::int64_t>(lines.size());
  const auto count = std::clamp<std::int64_t>(integer_in(params, "count", size), 0, size);
  Json store = Json::array();
  for (std::int64_t i = size - count; i < size; ++i) {
    const Json& line = lines.at(static_cast<std::size_t>(i));
    std::string text = line.at("text");
    const bool is_command = text.starts_with("> ");
    if (is_command) text.erase(0, 2);
    store.push_back({{"message", text},
                     {"time", line.at("time_ms").get<double>() / 1000},
                     {"type", is_command ? "command" : "response"}});
  }
  return {{"gcode_store", store}};
}

Json temperatures(Core& core, const Json&, Connection*) { return core.temperatures.stored(); }

Json webcams(Core&, const Json&, Connection*) { return {{"webcams", Json::array()}}; }

Json announcements(Core&, const Json&, Connection*) {
  return {{"entries", Json::array()}, {"feeds", Json::array()}};
}
Json feeds(Core&, const Json&, Connection*) { return {{"feeds", Json::array()}}; }

Json refuse(Core&, const Json&, Connection*) {
  throw Error(403, "the spooler is not restarted from here");
}

}  // namespace

double event_time() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

double unix_time() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

std::vector<Method> server_methods() {
  return {{"server.info", "GET", "/server/info", info},
          {"server.config", "GET", "/server/config", config},
          {"server.connection.identify", "", "", identify, true},
          {"server.websocket.id", "", "", number},
          {"server.gcode_store", "GET", "/server/gcode_store", console},
          {"server.temperature_store", "GET", "/server/temperature_store", temperatures},
          {"server.webcams.list", "GET", "/server/webcams/list", webcams},
          {"server.announcements.list", "GET", "/server/announcements/list", announcements},
          {"server.announcements.feeds", "GET", "/server/announcements/feeds", feeds},
          {"server.restart", "POST", "/server/restart", refuse}};
}

}  // namespace moonraker
