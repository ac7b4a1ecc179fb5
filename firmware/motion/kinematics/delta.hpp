// SPDX-License-Identifier: Apache-2.0
// Three carriages on vertical towers carry the tool by rods of one length (linear delta).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "motion/kinematics/division.hpp"
#include "motion/kinematics/kinematics.hpp"

namespace motion::kinematics {

// A motor's place is the height of its carriage's joint above the joint of the tool at Z = 0:
//   Z + sqrt(rod^2 - (X - x)^2 - (Y - y)^2), with the tower at x, y,
// where X, Y and the root are rounded to the nanometre and Z is exact, so that moves of Z alone
// never drift. Towers A, B, C stand at 210, 330 and 90 degrees about the origin, as in Marlin,
// each with trims of its angle and of its rods.
class Delta {
 public:
  struct Tower {
    units::Nanometers x{}, y{};

    bool operator==(const Tower&) const = default;
  };
  // Lengths up to 1 m, so that their squares fit.
  struct Parameters {
    units::Nanometers rod{250'000'000};
    units::Nanometers radius{105'000'000};  // of the towers, from joint to joint
    units::Nanometers height{250'000'000};  // Z at home
    units::Nanometers printable_radius{80'000'000};
    std::array<Tower, spatial_axes> towers{};
    // What a carriage goes down from its end stop to be at home, 0 or below.
    std::array<units::Nanometers, spatial_axes> end_stop_offset{};
    // M665: what a tower stands off its direction, counter-clockwise, in millionths of a degree;
    // what its rods are longer than the others.
    std::array<std::int32_t, spatial_axes> angle_trim{};
    std::array<units::Nanometers, spatial_axes> rod_trim{};

    bool operator==(const Parameters&) const = default;
  };
  static constexpr bool may_be_delta = true;
  static constexpr bool may_home_motors = true;
  using Chords = Division;

  Delta() : Delta(Parameters{}) {}
  explicit Delta(const Parameters& parameters) : parameters_(parameters) {}

  const Parameters& parameters() const { return parameters_; }
  const Delta* delta() const { return this; }

  static constexpr bool identity() { return false; }
  static constexpr bool straight() { return false; }
  static constexpr bool homes_motors() { return true; }
  static constexpr std::size_t curved_motors() { return spatial_axes; }
  static constexpr std::string_view motor_letters() { return "ABC"; }

  // Within the printable radius and the cone below home in which no carriage is above its place at
  // home: between two such places the line has only such places.
  bool reaches(const Place& tool) const;
  static constexpr bool straight_within(const Place&, const Place&) { return true; }
  Place motors_of(const Place& tool) const;
  // By Newton's method; within 5 nm where the place is within reach, else any place.
  Place place_of(const Place& motors) const;
  std::uint32_t chords(const Place& from, const Place& to) const;
  // At which the carriages' acceleration by the curvature of their ways is not above `most`.
  units::MicrometersPerSecond speed_limit(const Place& from, const Place& to,
                                          units::MicrometersPerSecondSquared most) const;
  Home home() const;

 private:
  units::Nanometers rod(std::size_t tower) const {
    return parameters_.rod + parameters_.rod_trim[tower];
  }
  units::Nanometers shortest_rod() const { return std::min({rod(0), rod(1), rod(2)}); }
  units::Nanometers longest_rod() const { return std::max({rod(0), rod(1), rod(2)}); }
  // How high carriages are above the tool, nm; the lowest one of those at both places.
  std::uint32_t rise(std::size_t tower, units::Nanometers x, units::Nanometers y) const;
  std::uint32_t lowest_rise(const Place& from, const Place& to) const;

  Parameters parameters_;
};

static_assert(Model<Delta>);

}  // namespace motion::kinematics
