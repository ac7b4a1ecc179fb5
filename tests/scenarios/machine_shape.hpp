// SPDX-License-Identifier: Apache-2.0
// How the motors of a machine move its tool, from drawings of the machines: shares nothing with the
// firmware or the simulation.
#pragma once

#include <array>
#include <cstddef>
#include <string>

namespace scenarios {

using Vector = std::array<double, 3>;  // X Y Z of the tool, or of the motors, mm

struct MachineShape {
  std::string kinematics = "cartesian";
  double rod{}, radius{}, height{};  // of a delta

  bool has_own_motor(std::size_t axis) const {
    return kinematics == "cartesian" || (kinematics == "core_xy" && axis == 2);
  }
  bool is_straight() const { return kinematics != "delta"; }
  Vector home() const { return {0, 0, is_straight() ? 0 : height}; }
  // To the nanometre where the firmware's documentation rounds to it.
  Vector motors_of(const Vector& tool) const;
  Vector tool_of(const Vector& motors) const;

 private:
  double carriage_above(std::size_t tower, double x, double y) const;
};

}  // namespace scenarios
