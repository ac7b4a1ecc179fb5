// SPDX-License-Identifier: Apache-2.0
// printer.objects: what there is, what it is now, and what changes.
#include "host/moonraker/core.hpp"
#include "host/moonraker/method_tables.hpp"

namespace moonraker {

namespace {

Json wanted_in(const Json& params) {
  const auto found = params.find("objects");
  if (found == params.end()) throw Error(invalid_params, "`objects` is missing");
  return *found;
}

Json list(Core& core, const Json&, Connection*) {
  const Json objects = core.view().objects();
  Json names = Json::array();
  for (const auto& [name, object] : objects.items()) names.push_back(name);
  return {{"objects", names}};
}

Json query(Core& core, const Json& params, Connection*) {
  return {{"eventtime", event_time()},
          {"status", selected(core.view().objects(), wanted_in(params))}};
}

Json subscribe(Core& core, const Json& params, Connection* connection) {
  std::shared_ptr<Connection> other;
  if (connection == nullptr) {  // over HTTP, for a WebSocket that is open
    other = core.hub.find(integer_in(params, "connection_id", 0));
    if (!other) throw Error(404, "there is no such connection_id");
  }
  Connection& subscriber = other ? *other : *connection;
  const Json wanted = wanted_in(params);
  Json status = selected(core.view().objects(), wanted);
  subscriber.subscribe(wanted, status);
  if (other) subscriber.begin_updates();
  return {{"eventtime", event_time()}, {"status", std::move(status)}};
}

}  // namespace

std::vector<Method> object_methods() {
  return {{"printer.objects.list", "GET", "/printer/objects/list", list},
          {"printer.objects.query", "POST", "/printer/objects/query", query},
          {"printer.objects.subscribe", "POST", "/printer/objects/subscribe", subscribe}};
}

}  // namespace moonraker
