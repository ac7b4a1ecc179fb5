// SPDX-License-Identifier: Apache-2.0
// The part of JSON Schema that the description of the API uses.
#pragma once

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

namespace host_test {

inline bool is_of_type(const nlohmann::json& value, const std::string& type) {
  if (type == "object") return value.is_object();
  if (type == "array") return value.is_array();
  if (type == "string") return value.is_string();
  if (type == "boolean") return value.is_boolean();
  if (type == "integer") return value.is_number_integer();
  if (type == "number") return value.is_number();
  return type == "null" && value.is_null();
}

// `document` resolves references. What does not fit, with its place; empty: the value fits.
inline std::string misfit(const nlohmann::json& value, const nlohmann::json& schema,
                          const nlohmann::json& document, const std::string& place = "answer") {
  using nlohmann::json;
  if (schema.contains("$ref")) {
    const std::string reference = schema.at("$ref");
    return misfit(value, document.at(json::json_pointer(reference.substr(1))), document, place);
  }
  if (schema.contains("type")) {
    const json& type = schema.at("type");
    const json types = type.is_array() ? type : json::array({type});
    if (std::ranges::none_of(types, [&](const json& each) { return is_of_type(value, each); })) {
      return place + " is no " + types.dump() + ": " + value.dump().substr(0, 100);
    }
  }
  if (schema.contains("enum") && !std::ranges::contains(schema.at("enum"), value)) {
    return place + " is none of " + schema.at("enum").dump() + ": " + value.dump();
  }
  if (value.is_object()) {
    for (const json& name : schema.value("required", json::array())) {
      if (!value.contains(name)) return place + " lacks " + name.get<std::string>();
    }
    const json properties = schema.value("properties", json::object());
    for (const auto& [name, field] : value.items()) {
      if (!properties.contains(name)) {
        if (schema.contains("additionalProperties")) {
          return place + "." + name + " is not described";
        }
        continue;
      }
      auto fault = misfit(field, properties.at(name), document, place + "." + name);
      if (!fault.empty()) return fault;
    }
  }
  if (value.is_array()) {
    if (value.size() < schema.value("minItems", std::size_t{0}) ||
        value.size() > schema.value("maxItems", value.size())) {
      return place + " has " + std::to_string(value.size()) + " elements";
    }
    for (std::size_t i = 0; i < value.size() && schema.contains("items"); ++i) {
      auto fault =
          misfit(value[i], schema.at("items"), document, place + "[" + std::to_string(i) + "]");
      if (!fault.empty()) return fault;
    }
  }
  return {};
}

}  // namespace host_test
