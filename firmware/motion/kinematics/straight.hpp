// SPDX-License-Identifier: Apache-2.0
// What all kinematics have in common in which a straight line is one for the motors too.
#pragma once

#include "motion/kinematics/division.hpp"
#include "motion/kinematics/kinematics.hpp"

namespace motion::kinematics {

class Straight {
 public:
  static constexpr bool may_be_delta = false;
  static constexpr const Delta* delta() { return nullptr; }
  static constexpr bool may_home_motors = false;
  using Chords = NoDivision;

  static constexpr bool straight() { return true; }
  static constexpr bool homes_motors() { return false; }
  static constexpr std::size_t curved_motors() { return 0; }
  static constexpr bool reaches(const Place&) { return true; }
  static constexpr bool straight_within(const Place&, const Place&) { return true; }
  static constexpr std::uint32_t chords(const Place&, const Place&) { return 1; }
  static constexpr units::MicrometersPerSecond speed_limit(const Place&, const Place&,
                                                           units::MicrometersPerSecondSquared) {
    return max_speed;
  }
  static constexpr Home home() { return {}; }
};

}  // namespace motion::kinematics
