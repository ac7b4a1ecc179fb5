// SPDX-License-Identifier: Apache-2.0
// What a G-code file requests, in steps: an interpreter of its own, written from the meaning of the
// codes and sharing nothing with the firmware or the simulation.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace scenarios {

inline constexpr std::size_t axes = 4;  // x y z e

struct RequestedMove {
  int line{};  // in the file, from 1
  bool homing{};  // G28: ends with the homed axes at 0
  std::array<bool, axes> homed{};  // which
  std::array<std::int64_t, axes> steps{};  // position requested at the end
  std::array<double, axes> exact_steps{};  // the same before rounding
};

// Reads G0 G1 G28 G90 G91 G92 M82 M83 (all else requests no motion). Positions are mechanical: they
// start at 0 on every axis, E counts from its position at the start.
std::vector<RequestedMove> requested_moves(const std::filesystem::path& gcode,
                                           const std::array<double, axes>& steps_per_mm);

}  // namespace scenarios
