// SPDX-License-Identifier: Apache-2.0
// Reads which kinematics a machine has, and checks that its axes fit them.
#include "machine_generator/kinematics_description.hpp"

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

}  // namespace

void read_kinematics(Reader& root, application::MachineDescription& machine) {
  const std::string name = root.text("kinematics");
  if (name == "cartesian") return;
  if (name == "core_xy") return read_core_xy(root, machine);
  root.fail("kinematics", "must be \"cartesian\" or \"core_xy\"");
}

}  // namespace machine_generator
