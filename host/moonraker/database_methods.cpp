// SPDX-License-Identifier: Apache-2.0
// server.database: the settings of front ends.
#include "host/moonraker/core.hpp"
#include "host/moonraker/method_tables.hpp"

namespace moonraker {

namespace {

Json item(const Json& params, const std::string& key, const Json& value) {
  return {{"namespace", text_in(params, "namespace")},
          {"key", key.empty() ? Json() : Json(key)},
          {"value", value}};
}

// A name, or a list of its levels.
std::string key_in(const Json& params) {
  const auto key = params.find("key");
  if (key == params.end() || key->is_null()) return "";
  if (!key->is_array()) return text_in(params, "key");
  std::string joined;
  for (const Json& level : *key) joined += (joined.empty() ? "" : ".") + level.get<std::string>();
  return joined;
}

Json list(Core& core, const Json&, Connection*) {
  return {{"namespaces", core.settings.namespaces()}, {"backups", Json::array()}};
}

Json read(Core& core, const Json& params, Connection*) {
  const std::string key = key_in(params);
  return item(params, key, core.settings.item(text_in(params, "namespace"), key));
}

Json write(Core& core, const Json& params, Connection*) {
  const std::string key = key_in(params);
  const auto value = params.find("value");
  if (value == params.end()) throw Error(invalid_params, "`value` is missing");
  core.settings.set(text_in(params, "namespace"), key, *value);
  return item(params, key, *value);
}

Json remove(Core& core, const Json& params, Connection*) {
  const std::string key = key_in(params);
  return item(params, key, core.settings.remove(text_in(params, "namespace"), key));
}

}  // namespace

std::vector<Method> database_methods() {
  return {{"server.database.list", "GET", "/server/database/list", list},
          {"server.database.get_item", "GET", "/server/database/item", read},
          {"server.database.post_item", "POST", "/server/database/item", write},
          {"server.database.delete_item", "DELETE", "/server/database/item", remove}};
}

}  // namespace moonraker
