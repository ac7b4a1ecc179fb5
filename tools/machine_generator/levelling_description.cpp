// SPDX-License-Identifier: Apache-2.0
// Reads what is known of the probe, and where it measures the bed.
#include "machine_generator/levelling_description.hpp"

#include <fmt/format.h>

#include <cmath>
#include <variant>

namespace machine_generator {
namespace {

using units::Nanometers;

constexpr std::int64_t per_mm = 1'000'000;
constexpr std::int64_t most_offset_mm = 100, most_offset_z_mm = 20, most_height_mm = 10;
constexpr std::int64_t end_stop_inputs = 8;

Nanometers length(Reader& table, const std::string& key, std::int64_t least_mm,
                  std::int64_t most_mm) {
  return Nanometers(table.scaled(key, per_mm, least_mm * per_mm, most_mm * per_mm));
}

units::MicrometersPerSecond speed(Reader& table, const char* key) {
  return units::MicrometersPerSecond(
      static_cast<std::int32_t>(table.scaled(key, 1000, 1, motion::max_speed.count())));
}

motion::ProbeSettings read_probe(Reader table, const motion::Limits& limits) {
  motion::ProbeSettings probe{
      .input = static_cast<std::uint8_t>(table.whole("input", 0, end_stop_inputs - 1)),
      .offset = {length(table, "offset_x_mm", -most_offset_mm, most_offset_mm),
                 length(table, "offset_y_mm", -most_offset_mm, most_offset_mm),
                 length(table, "offset_z_mm", -most_offset_z_mm, most_offset_z_mm)},
      .fast_speed = speed(table, "speed_mm_s"),
      .slow_speed = speed(table, "slow_speed_mm_s"),
      .travel_speed = speed(table, "travel_speed_mm_s"),
      .clearance = length(table, "clearance_mm", 0, 100),
      .back_off = Nanometers(table.scaled("backoff_mm", per_mm, per_mm / 100, 20 * per_mm)),
      .deepest = length(table, "deepest_mm", -most_height_mm, 0)};
  table.finish();
  for (const motion::AxisLimits& axis : limits.axes) {
    if (axis.homing && axis.homing->end_stop == probe.input) {
      table.fail("input", "is the end stop of an axis already");
    }
  }
  if (probe.clearance <= probe.end_of_descent()) {
    table.fail("clearance_mm",
               "must be above deepest_mm less offset_z_mm, where the nozzle ends its descent");
  }
  const Nanometers highest = limits.of(units::Axis::z).travel;
  if (highest > Nanometers() && probe.clearance > highest) {
    table.fail("clearance_mm", "is above the travel of axes.z");
  }
  return probe;
}

motion::MeshSettings read_mesh(Reader table, const application::MachineDescription& machine,
                               const motion::ProbeSettings& probe) {
  constexpr std::array<const char*, 2> points{"points_x", "points_y"};
  constexpr std::array<const char*, 2> first{"min_x_mm", "min_y_mm"};
  constexpr std::array<const char*, 2> last{"max_x_mm", "max_y_mm"};
  constexpr std::int64_t farthest_mm = 1000;
  motion::MeshSettings mesh;
  for (std::size_t i = 0; i < mesh.axes.size(); ++i) {
    mesh.axes[i] = {.first = length(table, first[i], -farthest_mm, farthest_mm),
                    .last = length(table, last[i], -farthest_mm, farthest_mm),
                    .points = static_cast<std::uint8_t>(table.whole(
                        points[i], 2, static_cast<std::int64_t>(motion::BedMesh::most_points)))};
    if (mesh.axes[i].last - mesh.axes[i].first < Nanometers(per_mm)) {
      table.fail(last[i], fmt::format("must be 1 mm above {} at least", first[i]));
    }
    const Nanometers travel = machine.limits.axes[i].travel;
    if (travel == Nanometers()) {
      continue;  // a delta: below
    }
    if (mesh.axes[i].first - probe.offset[i] < Nanometers()) {
      table.fail(first[i], "is where the probe, by its offset, cannot be");
    }
    if (mesh.axes[i].last - probe.offset[i] > travel) {
      table.fail(last[i], "is where the probe, by its offset, cannot be");
    }
  }
  mesh.fade_height = length(table, "fade_height_mm", 0, farthest_mm);
  table.finish();
  using motion::kinematics::Delta;
  if (const auto* delta = std::get_if<Delta::Parameters>(&machine.kinematics)) {
    for (const Nanometers x : {mesh.axes[0].first, mesh.axes[0].last}) {
      for (const Nanometers y : {mesh.axes[1].first, mesh.axes[1].last}) {
        const double away =
            std::hypot((x - probe.offset[0]).count(), (y - probe.offset[1]).count());
        if (away > static_cast<double>(delta->printable_radius.count())) {
          table.fail("max_x_mm", "or another border has a corner that the probe does not reach");
        }
      }
    }
  }
  return mesh;
}

// The simulated printer's alone.
void check_surface(Reader table) {
  for (const char* key :
       {"left_front_mm", "right_front_mm", "left_back_mm", "right_back_mm", "middle_mm"}) {
    length(table, key, -most_height_mm, most_height_mm);
  }
  table.finish();
}

}  // namespace

std::optional<motion::LevellingSettings> read_levelling(
    Reader& root, const application::MachineDescription& machine) {
  if (!root.has("probe")) {
    for (const char* key : {"mesh", "bed_surface"}) {
      if (root.has(key)) root.fail(key, "needs a table [probe]");
    }
    return std::nullopt;
  }
  // The mesh is that of the first nozzle's places, and E of levelled lines that of the first tool.
  if (root.has("tool_1")) root.fail("probe", "a machine with [tool_1] cannot have one yet");
  if (root.has("bed_surface")) check_surface(root.table("bed_surface"));
  motion::LevellingSettings levelling;
  levelling.probe = read_probe(root.table("probe"), machine.limits);
  levelling.mesh = read_mesh(root.table("mesh"), machine, levelling.probe);
  return levelling;
}

std::string levelling_text(const motion::LevellingSettings& settings) {
  const auto text = [](Nanometers value) {
    return fmt::format("units::Nanometers{{{}}}", value.count());
  };
  const auto speed_text = [](units::MicrometersPerSecond value) {
    return fmt::format("units::MicrometersPerSecond{{{}}}", value.count());
  };
  const motion::ProbeSettings& probe = settings.probe;
  std::string offsets, axes;
  for (const Nanometers offset : probe.offset) offsets += text(offset) + ", ";
  for (const motion::MeshAxis& axis : settings.mesh.axes) {
    axes += fmt::format("motion::MeshAxis{{.first = {}, .last = {}, .points = {}}}, ",
                        text(axis.first), text(axis.last), axis.points);
  }
  return fmt::format(
      "inline constexpr motion::LevellingSettings levelling{{\n"
      "      .probe = {{.input = {}, .offset = {{{{{}}}}},\n"
      "                .fast_speed = {}, .slow_speed = {},\n"
      "                .travel_speed = {}, .clearance = {},\n"
      "                .back_off = {}, .deepest = {}}},\n"
      "      .mesh = {{.axes = {{{{{}}}}},\n               .fade_height = {}}}}};\n\n",
      probe.input, offsets, speed_text(probe.fast_speed), speed_text(probe.slow_speed),
      speed_text(probe.travel_speed), text(probe.clearance), text(probe.back_off),
      text(probe.deepest), axes, text(settings.mesh.fade_height));
}

}  // namespace machine_generator
