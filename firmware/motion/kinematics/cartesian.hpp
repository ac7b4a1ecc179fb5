// SPDX-License-Identifier: Apache-2.0
// Each axis has a motor of its own.
#pragma once

#include "motion/kinematics/straight.hpp"

namespace motion::kinematics {

class Cartesian : public Straight {
 public:
  struct Parameters {};

  constexpr Cartesian() = default;
  explicit constexpr Cartesian(const Parameters&) {}

  static constexpr bool identity() { return true; }
  static constexpr std::string_view motor_letters() { return "XYZ"; }
  static constexpr const Place& motors_of(const Place& tool) { return tool; }
  static constexpr const Place& place_of(const Place& motors) { return motors; }
};

static_assert(Model<Cartesian>);

}  // namespace motion::kinematics
