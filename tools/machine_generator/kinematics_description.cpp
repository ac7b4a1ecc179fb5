// SPDX-License-Identifier: Apache-2.0
// Reads which kinematics a machine has, and checks that its axes fit them.
#include "machine_generator/kinematics_description.hpp"

#include <cmath>
#include <numbers>

#include "machine_generator/scara_description.hpp"

namespace machine_generator {

using namespace motion;

namespace {

// Both motors of a CoreXY move both axes, so a step of either must be worth the same.
void read_core_xy(Reader& root, application::MachineDescription& machine) {
  const auto steps = [&](units::Axis axis) { return machine.limits.of(axis).steps_per_meter; };
  if (steps(units::Axis::x) != steps(units::Axis::y)) {
    root.table("axes").table("y").fail(
        "steps_per_mm", "must be that of axes.x: with core_xy both motors move both axes");
  }
  machine.kinematics = kinematics::CoreXy::Parameters{};
}

constexpr std::int64_t nanometers_per_mm = 1'000'000;
constexpr std::int64_t longest = 1'000'000'000;  // 1 m: its square fits

// As the simulated printer and the documentation have it: rounded to the nanometre.
kinematics::Delta::Tower tower_at(double degrees, double radius) {
  const double angle = degrees * std::numbers::pi / 180;
  return {.x = units::Nanometers(std::llround(radius * std::cos(angle))),
          .y = units::Nanometers(std::llround(radius * std::sin(angle)))};
}

void read_delta(Reader& root, application::MachineDescription& machine) {
  Reader table = root.table("delta");
  const auto length = [&](const char* key) {
    return units::Nanometers(table.scaled(key, nanometers_per_mm, nanometers_per_mm, longest));
  };
  kinematics::Delta::Parameters delta{.rod = length("rod_length_mm"),
                                      .radius = length("radius_mm"),
                                      .height = length("height_mm"),
                                      .printable_radius = length("printable_radius_mm")};
  constexpr std::int64_t most_offset = 10 * nanometers_per_mm;
  const auto offsets = table.scaled_list("end_stop_offset_mm", nanometers_per_mm, -most_offset, 0,
                                         kinematics::spatial_axes);
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    delta.end_stop_offset[i] = units::Nanometers(offsets[i]);
  }
  table.finish();
  if (delta.printable_radius >= delta.radius) {
    table.fail("printable_radius_mm", "must be below radius_mm");
  }
  const auto flattest = static_cast<double>((delta.radius + delta.printable_radius).count());
  constexpr double least_angle_cosine = 0.95;  // 18 degrees above the horizontal
  if (flattest > least_angle_cosine * static_cast<double>(delta.rod.count())) {
    table.fail("rod_length_mm",
               "must be 1.053 times radius_mm + printable_radius_mm at least: rods would lie flat");
  }
  constexpr std::array<double, kinematics::spatial_axes> angles{210, 330, 90};
  for (std::size_t i = 0; i < angles.size(); ++i) {
    delta.towers[i] = tower_at(angles[i], static_cast<double>(delta.radius.count()));
    // The tool is bounded by what the rods reach. A carriage is at home above.
    motion::AxisLimits& axis = machine.limits.axes[i];
    axis.homing->towards_positive = true;
    axis.travel = i == units::index_of(units::Axis::z) ? delta.height : units::Nanometers(0);
  }
  machine.kinematics = delta;
}

}  // namespace

void read_kinematics(Reader& root, application::MachineDescription& machine) {
  const std::string name = root.text("kinematics");
  if (name == "cartesian") return;
  if (name == "core_xy") return read_core_xy(root, machine);
  if (name == "delta") return read_delta(root, machine);
  if (name == "scara") return read_scara(root, machine);
  root.fail("kinematics", "must be \"cartesian\", \"core_xy\", \"delta\" or \"scara\"");
}

}  // namespace machine_generator
