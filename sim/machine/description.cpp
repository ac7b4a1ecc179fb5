// SPDX-License-Identifier: Apache-2.0
// Reads a machine description from TOML and says exactly which entry is missing.
#include "sim/machine/description.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <string_view>
#include <toml++/toml.hpp>

namespace machine {

namespace {

// One place in the file, that knows its name for messages.
class Entry {
 public:
  Entry(toml::node_view<const toml::node> node, std::string name)
      : node_(node), name_(std::move(name)) {}

  Entry operator[](std::string_view key) const {
    return {node_[key], name_.empty() ? std::string(key) : fmt::format("{}.{}", name_, key)};
  }
  explicit operator bool() const { return static_cast<bool>(node_); }

  double number() const { return positive(required(node_.value<double>(), "a number")); }
  std::uint64_t whole_number() const {
    const std::int64_t value = required(node_.value<std::int64_t>(), "a whole number");
    if (value < 0) {
      fail("is negative");
    }
    return static_cast<std::uint64_t>(value);
  }
  std::string text() const { return required(node_.value<std::string>(), "a text"); }

 private:
  [[noreturn]] void fail(std::string_view what) const {
    throw std::runtime_error(fmt::format("{} {}", name_, what));
  }
  template <class Value>
  Value required(const std::optional<Value>& value, std::string_view kind) const {
    if (!value) {
      fail(fmt::format("{} {}", node_ ? "is not" : "is missing:", kind));
    }
    return *value;
  }
  double positive(double value) const {
    if (!(value > 0)) {
      fail("is not above 0");
    }
    return value;
  }

  toml::node_view<const toml::node> node_;
  std::string name_;
};

AxisDescription axis_of(const Entry& root, char letter) {
  const Entry entry = root["axes"][std::string_view(&letter, 1)];
  const Entry driver = root["drivers"][entry["driver"].text()];
  AxisDescription axis;
  axis.steps_per_mm = entry["steps_per_mm"].number();
  axis.max_speed_mm_s = entry["max_speed_mm_s"].number();
  axis.max_acceleration_mm_s2 = entry["max_acceleration_mm_s2"].number();
  axis.jerk_mm_s = entry["jerk_mm_s"].number();
  if (entry["travel_mm"]) {
    axis.travel_mm = entry["travel_mm"].number();
  }
  if (entry["endstop"]) {
    axis.end_stop = entry["endstop"].whole_number();
  }
  axis.driver = {driver["high_ns"].whole_number(), driver["low_ns"].whole_number(),
                 driver["direction_setup_ns"].whole_number(),
                 driver["direction_hold_ns"].whole_number()};
  return axis;
}

HeaterDescription heater_of(const Entry& root, std::string_view name) {
  const Entry entry = root[name];
  const Entry thermistor = root["thermistors"][entry["thermistor"].text()];
  return {entry["sensor_channel"].whole_number(),
          entry["heater_channel"].whole_number(),
          entry["heater_watts"].number(),
          entry["max_c"].number(),
          thermistor["resistance_25c_ohms"].number(),
          thermistor["beta_k"].number()};
}

}  // namespace

Description read_description(const std::filesystem::path& file) {
  try {
    const toml::table table = toml::parse_file(file.string());
    const Entry root(toml::node_view<const toml::node>(table), "");
    Description description;
    description.name = root["name"].text();
    description.baud = static_cast<std::uint32_t>(root["serial"]["baud"].whole_number());
    for (std::size_t i = 0; i < axis_count; ++i) {
      description.axes[i] = axis_of(root, axis_letters[i]);
    }
    description.hotend = heater_of(root, "hotend");
    description.bed = heater_of(root, "bed");
    const Entry converter = root["temperature_converter"];
    description.converter = {converter["capacitor_nf"].number(),
                             converter["reference_low_ohms"].number(),
                             converter["reference_high_ohms"].number(),
                             converter["supply_v"].number(), converter["threshold_v"].number()};
    return description;
  } catch (const toml::parse_error& error) {
    throw std::runtime_error(
        fmt::format("{}:{}: {}", file.string(), error.source().begin.line, error.description()));
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(fmt::format("{}: {}", file.string(), error.what()));
  }
}

}  // namespace machine
