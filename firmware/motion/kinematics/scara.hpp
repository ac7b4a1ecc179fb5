// SPDX-License-Identifier: Apache-2.0
// Two arms that turn in the horizontal plane carry the tool, Z has its own motor (serial SCARA).
#pragma once

#include <array>

#include "motion/kinematics/division.hpp"
#include "motion/kinematics/kinematics.hpp"

namespace motion::kinematics {

// The places of the motors of X and Y are the directions of the arms, in degrees from the X axis,
// counter-clockwise. Both are absolute, as of Morgan's SCARA: where only the proximal arm turns,
// the distal one keeps its direction. With the shoulder at s:
//   X = s_x + proximal cos a + distal cos b, Y = s_y + proximal sin a + distal sin b
// Directions are whole millionths of a degree, within 1.5 of the exact ones; each is in the turn
// that ends 10 degrees beyond its end stop, so that no line passes from 360 to 0 degrees.
class Scara {
 public:
  using Millionths = units::Nanometers;  // of a degree, as units::Position has them

  struct Parameters {
    // Up to 0.5 m, and the shoulder up to 1 m from the bed, so that squares fit.
    units::Nanometers proximal{200'000'000}, distal{200'000'000};
    units::Nanometers shoulder_x{100'000'000}, shoulder_y{-120'000'000};
    bool elbow_left{};  // as seen from the shoulder towards the tool
    // Places of the tool: so far from the shoulder, and 0 .. width, depth, height.
    units::Nanometers inner_radius{130'000'000}, outer_radius{320'000'000};
    units::Nanometers width{200'000'000}, depth{200'000'000}, height{150'000'000};
    // Where homing ends, at Z = height.
    units::Nanometers home_x{10'000'000}, home_y{60'000'000};
    // Directions at which the end stops switch; -340 .. 340 degrees, at home or beyond.
    std::array<Millionths, 2> end_stop{Millionths(100'000'000), Millionths(215'000'000)};
  };
  static constexpr bool may_be_delta = false;
  static constexpr bool may_home_motors = true;
  using Chords = Division;
  // A target may be so far outside of the bounds that straight_within has for a whole line: chords
  // end at rounded places, and a stop leaves the tool at rounded steps.
  static constexpr units::Nanometers slack{100'000};

  Scara() : Scara(Parameters{}) {}
  explicit Scara(const Parameters& parameters) : parameters_(parameters) {}

  const Parameters& parameters() const { return parameters_; }
  static constexpr const Delta* delta() { return nullptr; }

  static constexpr bool identity() { return false; }
  static constexpr bool straight() { return false; }
  static constexpr bool homes_motors() { return true; }
  static constexpr std::size_t curved_motors() { return 2; }
  static constexpr std::string_view motor_letters() { return "ABZ"; }

  bool reaches(const Place& tool) const;
  // The bed and the outer circle are convex; the inner circle is looked at along the line.
  bool straight_within(const Place& from, const Place& to) const;
  // Any place; out of reach, stretched or folded arms.
  Place motors_of(const Place& tool) const;
  Place place_of(const Place& motors) const;
  std::uint32_t chords(const Place& from, const Place& to) const;
  // At which the arms' acceleration by the curvature of their ways is not above `most`, in
  // thousandths of a degree.
  units::MicrometersPerSecond speed_limit(const Place& from, const Place& to,
                                          units::MicrometersPerSecondSquared most) const;
  Home home() const;

 private:
  struct Span {
    std::uint64_t least, most;
  };
  struct Flat {
    std::int64_t x, y;
  };
  // From the shoulder, nm.
  Flat from_shoulder(const Place& tool) const;
  bool within(const Place& tool, units::Nanometers beyond) const;
  // The squares of the distance from the shoulder along a line, nm^2.
  static Span squares(const Flat& from, const Flat& to);
  // Of the elbow's angle, the least one between two places, 2^-30.
  std::uint32_t least_sine(const Place& from, const Place& to) const;
  std::uint32_t sine_at(std::uint64_t square) const;

  Parameters parameters_;
};

static_assert(Model<Scara>);

}  // namespace motion::kinematics
