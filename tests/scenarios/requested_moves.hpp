// SPDX-License-Identifier: Apache-2.0
// What a G-code file requests, in steps: an interpreter of its own, written from the meaning of the
// codes and sharing nothing with the firmware or the simulation.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "tests/scenarios/machine_shape.hpp"

namespace scenarios {

inline constexpr std::size_t axes = 4;  // x y z e

// The circle of a G2 or G3, in mm on the two axes of its plane.
struct RequestedArc {
  std::array<std::size_t, 2> plane{};
  std::array<double, 2> centre{};
  double start_radius{}, end_radius{};
  double sweep{};  // radians, from the plane's first axis to the second; negative with the clock
};

struct RequestedMove {
  int line{};  // in the file, from 1
  bool homing{};  // G28: ends with the homed axes at home
  std::array<bool, axes> homed{};  // which
  Vector tool{};  // X Y Z requested at the end, mm
  std::array<std::int64_t, axes> steps{};  // the motors' position for it
  std::array<double, axes> exact_steps{};  // the same before rounding
  std::optional<RequestedArc> arc;
};

// Reads G0 to G3, G10 G11, G17 to G19, G28, G90 to G92, M82 M83, M207 M208 (all else requests no
// motion). Positions are mechanical: they start at 0 on every axis, E counts from its position at
// the start. Without homing or a stop between G10 and G11.
std::vector<RequestedMove> requested_moves(const std::filesystem::path& gcode,
                                           const std::array<double, axes>& steps_per_mm,
                                           const MachineShape& shape = {});

}  // namespace scenarios
