// SPDX-License-Identifier: Apache-2.0
// Each axis has a motor of its own.
#pragma once

#include "motion/kinematics/division.hpp"
#include "motion/kinematics/kinematics.hpp"

namespace motion::kinematics {

class Cartesian {
 public:
  struct Parameters {};
  static constexpr bool may_home_motors = false;
  using Chords = NoDivision;

  constexpr Cartesian() = default;
  explicit constexpr Cartesian(const Parameters&) {}

  static constexpr bool identity() { return true; }
  static constexpr bool straight() { return true; }
  static constexpr bool homes_motors() { return false; }
  static constexpr std::string_view motor_letters() { return "XYZ"; }
  static constexpr bool reaches(const Place&) { return true; }
  static constexpr const Place& motors_of(const Place& tool) { return tool; }
  static constexpr const Place& place_of(const Place& motors) { return motors; }
  static constexpr std::uint32_t chords(const Place&, const Place&, units::MicrometersPerSecond) {
    return 1;
  }
  static constexpr units::MicrometersPerSecond speed_limit(const Place&, const Place&,
                                                           units::MicrometersPerSecondSquared) {
    return max_speed;
  }
  static constexpr Home home() { return {}; }
};

static_assert(Model<Cartesian>);

}  // namespace motion::kinematics
