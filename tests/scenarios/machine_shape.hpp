// SPDX-License-Identifier: Apache-2.0
// How the motors of a machine move its tool, from drawings of the machines: shares nothing with the
// firmware or the simulation.
#pragma once

#include <array>
#include <cstddef>
#include <string>

namespace scenarios {

// X Y Z of the tool, or of the motors, mm; of motors that turn arms, degrees.
using Vector = std::array<double, 3>;

struct MachineShape {
  std::string kinematics = "cartesian";
  double rod{}, radius{}, height{};  // of a delta; height of a SCARA too
  // Of a SCARA: lengths of both arms, the shoulder's place, 1 for the elbow on the left of the way
  // to the tool, directions of the arms at their end stops in degrees, X and Y of home.
  std::array<double, 2> arms{}, shoulder{}, end_stops{}, home_place{};
  double elbow_side = -1;

  bool has_own_motor(std::size_t axis) const {
    return kinematics == "cartesian" || (kinematics != "delta" && axis == 2);
  }
  bool is_straight() const { return kinematics == "cartesian" || kinematics == "core_xy"; }
  // How far the tool goes with a degree or millimetre of the motors of X and Y.
  double tool_way() const;
  Vector home() const { return {home_place[0], home_place[1], is_straight() ? 0 : height}; }
  // To the nanometre where the firmware's documentation rounds to it.
  Vector motors_of(const Vector& tool) const;
  Vector tool_of(const Vector& motors) const;

 private:
  double carriage_above(std::size_t tower, double x, double y) const;
  Vector arms_to(const Vector& tool) const;
  Vector tool_delta_holds(const Vector& motors) const;
};

}  // namespace scenarios
