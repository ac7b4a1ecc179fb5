// SPDX-License-Identifier: Apache-2.0
// What the command line says of MQTT, and what a printer's topic holds.
#include <algorithm>
#include <stdexcept>

#include "host/notify/mqtt.hpp"
#include "host/notify/secret_file.hpp"
#include "host/web/address.hpp"

namespace notify {

namespace {

constexpr std::size_t longest_topic = 200;

bool is_topic(const std::string& topic) {
  const bool whole = std::ranges::all_of(
      topic, [](char c) { return c > ' ' && c <= '~' && c != '+' && c != '#'; });
  return whole && !topic.empty() && topic.size() <= longest_topic && topic.front() != '/' &&
         topic.front() != '$' && topic.back() != '/' && !topic.contains("//");
}

std::string state_of(const Json& printer, const Json* job) {
  if (printer.at("waits_for_user") && printer.at("link") == "ready") return "waits_for_user";
  if (job != nullptr) return job->at("state");
  return printer.at("link") == "ready" ? "idle" : "away";
}

}  // namespace

MqttOptions mqtt_options(const std::string& address, const std::filesystem::path& login,
                         const std::string& topic) {
  MqttOptions options{.topic = topic};
  try {
    const web::Address broker = web::address_of(address, usual_mqtt_port);
    options.host = broker.host;
    options.port = broker.port;
  } catch (const std::runtime_error&) {
    options.port = 0;
  }
  if (address.empty() || options.port == 0) {
    throw std::runtime_error("--mqtt " + address + ": not HOST[:PORT]");
  }
  if (!is_topic(topic)) {
    throw std::runtime_error("--mqtt-topic " + topic +
                             ": no levels with + or #, and no / at begin or end");
  }
  if (!login.empty()) {
    const auto lines = read_secret(login, 2);
    options.user = lines[0];
    options.password = lines[1];
  }
  return options;
}

Json printer_state(const Json& snapshot, const Json& printer) {
  const Json& jobs = snapshot.at("jobs");
  const auto found = std::ranges::find_if(
      jobs, [&](const Json& each) { return each.at("id") == printer.at("job"); });
  const Json* const job = found == jobs.end() ? nullptr : &*found;
  Json state{{"state", state_of(printer, job)},
             {"job", printer.at("job")},
             {"file", job != nullptr ? job->at("name") : Json()},
             {"done", job != nullptr ? printer.at("done") : Json()},
             {"commands", job != nullptr ? job->at("commands") : Json()}};
  for (const char* name : {"link", "fault", "bed_clear", "hotend", "bed"}) {
    state[name] = printer.at(name);
  }
  return state;
}

}  // namespace notify
