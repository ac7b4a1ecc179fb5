// SPDX-License-Identifier: Apache-2.0
// Takes from a machine description what the simulation needs, after the checks of the
// firmware's generator.
#include "sim/machine/description.hpp"

#include <fmt/format.h>

#include <limits>
#include <string_view>
#include <toml++/toml.hpp>
#include <utility>

#include "machine_generator/header.hpp"
#include "machine_generator/reader.hpp"
#include "sim/machine/delta_mechanism.hpp"
#include "sim/machine/scara_mechanism.hpp"
#include "sim/simulation/pins.hpp"

namespace machine {

namespace {

// One place in a file that has been checked: what is read is there, has its type and its range.
class Entry {
 public:
  explicit Entry(toml::node_view<const toml::node> node) : node_(node) {}

  Entry operator[](std::string_view key) const { return Entry(node_[key]); }
  Entry operator[](std::size_t index) const { return Entry(node_[index]); }
  explicit operator bool() const { return static_cast<bool>(node_); }

  double number() const { return node_.value<double>().value(); }
  std::uint64_t whole_number() const {
    return static_cast<std::uint64_t>(node_.value<std::int64_t>().value());
  }
  std::string text() const { return node_.value<std::string>().value(); }

 private:
  toml::node_view<const toml::node> node_;
};

devices::DriverTiming driver_of(const Entry& root, const Entry& motor) {
  const Entry driver = root["drivers"][motor["driver"].text()];
  return {driver["high_ns"].whole_number(), driver["low_ns"].whole_number(),
          driver["direction_setup_ns"].whole_number(), driver["direction_hold_ns"].whole_number()};
}

AxisDescription axis_of(const Entry& root, char letter) {
  const Entry entry = root["axes"][std::string_view(&letter, 1)];
  AxisDescription axis;
  axis.steps_per_mm = entry["steps_per_mm"].number();
  axis.max_speed_mm_s = entry["max_speed_mm_s"].number();
  axis.max_acceleration_mm_s2 = entry["max_acceleration_mm_s2"].number();
  axis.jerk_mm_s = entry["jerk_mm_s"].number();
  if (entry["travel_mm"]) axis.travel_mm = entry["travel_mm"].number();
  if (entry["endstop"]) axis.end_stop = entry["endstop"].whole_number();
  axis.driver = driver_of(root, entry);
  return axis;
}

plants::HeatedBlockProperties block_of(const Entry& heater) {
  const Entry model = heater["model"];
  return {.heater_watts = heater["heater_watts"].number(),
          .path = {.heater_joules_per_kelvin = model["heater_j_per_k"].number(),
                   .heater_to_block_watts_per_kelvin = model["heater_to_block_w_per_k"].number(),
                   .block_joules_per_kelvin = model["block_j_per_k"].number(),
                   .sensor_lag_seconds = model["sensor_lag_s"].number()},
          .loss_watts_per_kelvin = model["loss_w_per_k"].number(),
          .fan_loss_watts_per_kelvin = model["fan_loss_w_per_k"].number()};
}

HeaterDescription heater_of(const Entry& root, const Entry& entry) {
  const Entry thermistor = root["thermistors"][entry["thermistor"].text()];
  return {entry["sensor_channel"].whole_number(),
          entry["heater_channel"].whole_number(),
          block_of(entry),
          entry["max_c"].number(),
          thermistor["resistance_25c_ohms"].number(),
          thermistor["beta_k"].number()};
}

ToolDescription tool_of(const Entry& root, const Entry& tool) {
  const Entry change = root["tool_change"];
  ToolDescription description{.hotend = heater_of(root, tool["hotend"]),
                              .driver = driver_of(root, tool),
                              .swap_mm = change["swap_length_mm"].number(),
                              .resume_mm = change["resume_extra_mm"].number(),
                              .prime_mm = change["prime_length_mm"].number(),
                              .lift_mm = change["lift_mm"].number()};
  for (std::size_t i = 0; i < description.offset_mm.size(); ++i) {
    description.offset_mm[i] = tool["offset_mm"][i].number();
  }
  return description;
}

ScaraProperties scara_of(const Entry& scara) {
  const auto pair = [&](const char* key) {
    return std::array{scara[key][0].number(), scara[key][1].number()};
  };
  return {.proximal = scara["proximal_mm"].number(),
          .distal = scara["distal_mm"].number(),
          .elbow_left = scara["elbow"].text() == "left",
          .shoulder = pair("shoulder_mm"),
          .end_stop = pair("end_stop_deg"),
          .home = pair("home_mm"),
          .height = scara["height_mm"].number()};
}

std::shared_ptr<const Mechanism> mechanism_of(const Entry& root) {
  const std::string name = root["kinematics"].text();
  if (name == "core_xy") return core_xy_mechanism();
  if (name == "scara") return scara_mechanism(scara_of(root["scara"]));
  if (name == "delta") {
    const Entry delta = root["delta"];
    DeltaProperties properties{.rod = delta["rod_length_mm"].number(),
                               .radius = delta["radius_mm"].number(),
                               .height = delta["height_mm"].number(),
                               .printable_radius = delta["printable_radius_mm"].number()};
    const Entry offsets = delta["end_stop_offset_mm"];
    for (std::size_t i = 0; i < properties.end_stop_offset.size(); ++i) {
      properties.end_stop_offset[i] = offsets[i].number();
    }
    return delta_mechanism(properties);
  }
  return cartesian_mechanism();
}

ProbeDescription probe_of(const Entry& probe, const Entry& mesh) {
  return {.input = probe["input"].whole_number(),
          .offset_mm = {probe["offset_x_mm"].number(), probe["offset_y_mm"].number(),
                        probe["offset_z_mm"].number()},
          .clearance_mm = probe["clearance_mm"].number(),
          .mesh_from_mm = {mesh["min_x_mm"].number(), mesh["min_y_mm"].number()},
          .mesh_to_mm = {mesh["max_x_mm"].number(), mesh["max_y_mm"].number()},
          .mesh_points = {mesh["points_x"].whole_number(), mesh["points_y"].whole_number()},
          .fade_height_mm = mesh["fade_height_mm"].number()};
}

BacklashDescription backlash_of(const Entry& backlash) {
  BacklashDescription description{
      {backlash["x_mm"].number(), backlash["y_mm"].number(), backlash["z_mm"].number()}};
  if (const Entry part = backlash["correction"]) description.correction = part.number();
  return description;
}

ShapingDescription shaping_of(const Entry& shaping) {
  ShapingDescription description;
  for (std::size_t i = 0; i < description.shapers.size(); ++i) {
    const Entry shaper = shaping[i == 0 ? "x" : "y"];
    if (!shaper) continue;
    description.shapers[i] = {shaper["type"].text(), shaper["frequency_hz"].number(),
                              shaper["damping"].number()};
  }
  description.advance_s = shaping["advance_s"].number();
  return description;
}

BedSurface surface_of(const Entry& surface) {
  return {.left_front = surface["left_front_mm"].number(),
          .right_front = surface["right_front_mm"].number(),
          .left_back = surface["left_back_mm"].number(),
          .right_back = surface["right_back_mm"].number(),
          .middle = surface["middle_mm"].number()};
}

// A chip has a third one of each where there is a second hotend.
void check_channels(machine_generator::Reader reader, std::size_t count) {
  const auto last = static_cast<std::int64_t>(count) - 1;
  for (const char* key : {"heater_channel", "sensor_channel"}) {
    const std::int64_t channel = reader.whole(key, 0, std::numeric_limits<std::int64_t>::max());
    if (channel > last) {
      reader.fail(key, fmt::format("is {}, but the simulated chip has 0 to {}", channel, last));
    }
  }
}

void check_channels(const toml::table& table, const std::filesystem::path& file) {
  machine_generator::Reader root(file, table);
  const bool second = root.has("tool_1");
  const std::size_t count = second ? sim::most_heaters : sim::heater_count;
  for (const char* heater : {"hotend", "bed"}) check_channels(root.table(heater), count);
  if (second) check_channels(root.table("tool_1").table("hotend"), count);
}

Description description_of(const toml::table& table, const std::filesystem::path& file) {
  machine_generator::check(table, file);
  check_channels(table, file);
  const Entry root{toml::node_view<const toml::node>(table)};
  Description description;
  description.name = root["name"].text();
  description.baud = static_cast<std::uint32_t>(root["serial"]["baud"].whole_number());
  if (const Entry memory = root["memory_kib"]) {
    constexpr std::uint32_t bytes_per_kib = 1024;
    description.memory_bytes = static_cast<std::uint32_t>(memory.whole_number()) * bytes_per_kib;
  }
  for (std::size_t i = 0; i < axis_count; ++i) description.axes[i] = axis_of(root, axis_letters[i]);
  description.mechanism = mechanism_of(root);
  if (const Entry retraction = root["retraction"]) {
    description.retraction = {retraction["length_mm"].number(), retraction["lift_mm"].number(),
                              retraction["extra_mm"].number()};
  }
  if (const Entry play = root["backlash"]) description.backlash = backlash_of(play);
  if (const Entry change = root["filament_change"]) {
    description.filament_change = {change["load_mm"].number(), change["unload_mm"].number(),
                                   change["purge_mm"].number()};
  }
  if (const Entry shaping = root["shaping"]) description.shaping = shaping_of(shaping);
  if (const Entry probe = root["probe"]) description.probe = probe_of(probe, root["mesh"]);
  if (const Entry surface = root["bed_surface"]) description.bed_surface = surface_of(surface);
  for (std::size_t i = 0; i < description.bed_surface.size.size(); ++i) {
    description.bed_surface.size[i] = description.axes[i].travel_mm.value_or(1);
  }
  description.hotend = heater_of(root, root["hotend"]);
  description.bed = heater_of(root, root["bed"]);
  if (const Entry tool = root["tool_1"]) description.second_tool = tool_of(root, tool);
  const Entry converter = root["temperature_converter"];
  description.converter = {converter["capacitor_nf"].number(),
                           converter["reference_low_ohms"].number(),
                           converter["reference_high_ohms"].number(),
                           converter["supply_v"].number(), converter["threshold_v"].number()};
  return description;
}

}  // namespace

Description read_description(const std::filesystem::path& file) {
  return description_of(machine_generator::Reader::parse(file), file);
}

Description parse_description(std::string_view text, const std::filesystem::path& name) {
  return description_of(machine_generator::Reader::parse(text, name), name);
}

}  // namespace machine
