// SPDX-License-Identifier: Apache-2.0
// Reads what is known of play in drives, and of the filament's sensor and its way.
#include "machine_generator/parts_description.hpp"

#include <fmt/format.h>

#include <variant>

namespace machine_generator {
namespace {

using units::Nanometers;

constexpr std::int64_t per_mm = 1'000'000;
constexpr std::int64_t end_stop_inputs = 8;

Nanometers length(Reader& table, const std::string& key, Nanometers most) {
  return Nanometers(table.scaled(key, per_mm, 0, most.count()));
}

units::MicrometersPerSecond speed(Reader& table, const char* key) {
  return units::MicrometersPerSecond(
      static_cast<std::int32_t>(table.scaled(key, 1000, 1, motion::max_speed.count())));
}

motion::BacklashSettings read_backlash(Reader table) {
  constexpr std::array<const char*, motion::BacklashSettings::axes> keys{"x_mm", "y_mm", "z_mm"};
  motion::BacklashSettings backlash;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    backlash.lengths[i] = length(table, keys[i], motion::BacklashSettings::longest);
  }
  if (table.has("correction")) {
    backlash.correction = static_cast<std::uint32_t>(table.scaled(
        "correction", motion::BacklashSettings::whole, 0, motion::BacklashSettings::whole));
  }
  table.finish();
  return backlash;
}

application::FilamentSensor read_sensor(Reader table, const motion::Limits& limits,
                                        const std::optional<motion::LevellingSettings>& levelling) {
  const application::FilamentSensor sensor{
      .input = static_cast<std::uint8_t>(table.whole("input", 0, end_stop_inputs - 1)),
      .low_is_out = table.truth("low_is_out")};
  table.finish();
  for (const motion::AxisLimits& axis : limits.axes) {
    if (axis.homing && axis.homing->end_stop == sensor.input) {
      table.fail("input", "is the end stop of an axis already");
    }
  }
  if (levelling && levelling->probe.input == sensor.input) {
    table.fail("input", "is that of the probe already");
  }
  return sensor;
}

application::FilamentChange read_change(Reader table) {
  constexpr Nanometers longest = application::FilamentChange::longest;
  const application::FilamentChange change{.load = length(table, "load_mm", longest),
                                           .unload = length(table, "unload_mm", longest),
                                           .load_speed = speed(table, "load_speed_mm_s"),
                                           .unload_speed = speed(table, "unload_speed_mm_s"),
                                           .purge = length(table, "purge_mm", longest),
                                           .purge_speed = speed(table, "purge_speed_mm_s")};
  table.finish();
  return change;
}

std::string text(Nanometers value) { return fmt::format("units::Nanometers{{{}}}", value.count()); }

std::string text(units::MicrometersPerSecond value) {
  return fmt::format("units::MicrometersPerSecond{{{}}}", value.count());
}

}  // namespace

Parts read_parts(Reader& root, const application::MachineDescription& machine,
                 const std::optional<motion::LevellingSettings>& levelling) {
  Parts parts;
  if (root.has("backlash")) {
    // Where a motor moves several axes, or an axis along a curve, it turns back elsewhere.
    if (!std::holds_alternative<motion::kinematics::Cartesian::Parameters>(machine.kinematics)) {
      root.fail("backlash", "needs kinematics = \"cartesian\": a motor for each axis");
    }
    parts.backlash = read_backlash(root.table("backlash"));
  }
  if (root.has("filament_sensor")) {
    parts.filament_sensor = read_sensor(root.table("filament_sensor"), machine.limits, levelling);
  }
  if (root.has("filament_change")) {
    parts.filament_change = read_change(root.table("filament_change"));
  }
  return parts;
}

std::string parts_text(const Parts& parts) {
  std::string all;
  if (parts.backlash) {
    std::string lengths;
    for (const Nanometers length : parts.backlash->lengths) lengths += text(length) + ", ";
    all += fmt::format(
        "inline constexpr motion::BacklashSettings backlash{{\n"
        "      .lengths = {{{{{}}}}}, .correction = {}}};\n\n",
        lengths, parts.backlash->correction);
  }
  if (parts.filament_sensor) {
    all += fmt::format(
        "inline constexpr application::FilamentSensor filament_sensor{{\n"
        "      .input = {}, .low_is_out = {}}};\n\n",
        parts.filament_sensor->input, parts.filament_sensor->low_is_out);
  }
  if (parts.filament_change) {
    const application::FilamentChange& change = *parts.filament_change;
    all += fmt::format(
        "inline constexpr application::FilamentChange filament_change{{\n"
        "      .load = {}, .unload = {},\n      .load_speed = {}, .unload_speed = {},\n"
        "      .purge = {}, .purge_speed = {}}};\n\n",
        text(change.load), text(change.unload), text(change.load_speed), text(change.unload_speed),
        text(change.purge), text(change.purge_speed));
  }
  return all;
}

std::string parts_entries(const Parts& parts) {
  std::string all;
  if (parts.backlash) all += "  .backlash = &backlash,\n";
  if (parts.filament_sensor) all += "  .filament_sensor = &filament_sensor,\n";
  if (parts.filament_change) all += "  .filament_change = &filament_change,\n";
  return all;
}

}  // namespace machine_generator
