// SPDX-License-Identifier: Apache-2.0
// Two motors that stand still move X and Y with crossed belts: their sum and their difference.
#pragma once

#include "motion/kinematics/straight.hpp"

namespace motion::kinematics {

// As Marlin's COREXY: motor A, on the pins of X, is at X + Y, motor B, on those of Y, at X - Y.
// Both directions are exact: what G-code can request is a multiple of 200 fm.
class CoreXy : public Straight {
 public:
  struct Parameters {};

  constexpr CoreXy() = default;
  explicit constexpr CoreXy(const Parameters&) {}

  static constexpr bool identity() { return false; }
  static constexpr std::string_view motor_letters() { return "ABZ"; }
  static constexpr Place motors_of(const Place& tool) {
    return {tool[0] + tool[1], tool[0] - tool[1], tool[2], tool[3]};
  }
  static constexpr Place place_of(const Place& motors) {
    return {half(motors[0] + motors[1]), half(motors[0] - motors[1]), motors[2], motors[3]};
  }

 private:
  // Rounded down to a femtometre.
  static constexpr units::Position half(const units::Position& position) {
    constexpr std::uint32_t half_nanometer = units::Position::femtometers_per_nanometer / 2;
    const std::int64_t whole = position.whole().count();
    return {units::Nanometers(whole >> 1), static_cast<std::uint32_t>(position.femtometers()) / 2 +
                                               ((whole & 1) != 0 ? half_nanometer : 0)};
  }
};

static_assert(Model<CoreXy>);

}  // namespace motion::kinematics
