// SPDX-License-Identifier: Apache-2.0
// Objects of fields, compared field by field.
#include "host/moonraker/subscription.hpp"

#include <utility>

#include "host/moonraker/rpc.hpp"

namespace moonraker {

Json selected(const Json& objects, const Json& wanted) {
  if (!wanted.is_object()) throw Error(invalid_params, "`objects` must be an object");
  Json found = Json::object();
  for (const auto& [name, fields] : wanted.items()) {
    if (!fields.is_null() && !fields.is_array()) {
      throw Error(invalid_params, "the fields of " + name + " must be a list or null");
    }
    const auto object = objects.find(name);
    if (object == objects.end()) continue;
    if (fields.is_null()) {
      found[name] = *object;
      continue;
    }
    found[name] = Json::object();
    for (const Json& field : fields) {
      if (!field.is_string()) throw Error(invalid_params, "a field's name must be a text");
      const auto value = object->find(field.get_ref<const std::string&>());
      if (value != object->end()) found[name][field.get_ref<const std::string&>()] = *value;
    }
  }
  return found;
}

Json difference(const Json& now, const Json& before) {
  Json changes = Json::object();
  for (const auto& [name, object] : now.items()) {
    const auto old = before.find(name);
    for (const auto& [field, value] : object.items()) {
      const bool is_same = old != before.end() && old->contains(field) && old->at(field) == value;
      if (!is_same) changes[name][field] = value;
    }
  }
  return changes;
}

Json Subscription::changes_to(const Json& objects) {
  if (wanted.empty()) return Json::object();
  Json now = selected(objects, wanted);
  Json changes = difference(now, sent);
  sent = std::move(now);
  return changes;
}

}  // namespace moonraker
