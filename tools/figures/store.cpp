// SPDX-License-Identifier: Apache-2.0
// JSON in both directions.
#include "tools/figures/store.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace figures {

namespace {

using Json = nlohmann::ordered_json;

// A count is written as one, not as 2139.0.
Json number(double value) {
  constexpr double exact_up_to = 9e15;
  if (value == std::floor(value) && std::abs(value) < exact_up_to) {
    return static_cast<std::int64_t>(value);
  }
  return value;
}

Record record_of(const Json& json) {
  Record record{.command = json.at("command"),
                .measured = json.at("measured"),
                .machine = json.value("machine", ""),
                .values = {}};
  const Json& values = json.at("values");
  for (const auto& [name, value] : values.items()) record.values[name] = value.get<double>();
  return record;
}

}  // namespace

Store read_store(const std::filesystem::path& file) {
  Store store;
  try {
    std::ifstream stream(file);
    const Json all = Json::parse(stream);
    for (const auto& [name, json] : all.items()) store[name] = record_of(json);
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(fmt::format("{}: {}", file.string(), error.what()));
  }
  return store;
}

std::string to_json(const Store& store) {
  Json json = Json::object();
  for (const auto& [name, record] : store) {
    Json& entry = json[name] = {{"command", record.command}, {"measured", record.measured}};
    if (!record.machine.empty()) entry["machine"] = record.machine;
    entry["values"] = Json::object();
    for (const auto& [value_name, value] : record.values) {
      entry["values"][value_name] = number(value);
    }
  }
  return json.dump(2) + "\n";
}

}  // namespace figures
