// SPDX-License-Identifier: Apache-2.0
// SCARAs of several sizes, with the elbow on either side, and their geometry in floating point.
#pragma once

#include "motion/kinematics/scara.hpp"
#include "tests/motion/delta_machines.hpp"

namespace motion_test {

using motion::kinematics::Scara;

inline Scara::Parameters scara(std::array<int, 2> arms, std::array<int, 2> shoulder, bool left,
                               std::array<int, 2> radii, int bed, std::array<int, 2> end_stops) {
  const auto millions = [](int value) { return units::Nanometers(value * 1'000'000LL); };
  return {.proximal = millions(arms[0]),
          .distal = millions(arms[1]),
          .shoulder_x = millions(shoulder[0]),
          .shoulder_y = millions(shoulder[1]),
          .elbow_left = left,
          .inner_radius = millions(radii[0]),
          .outer_radius = millions(radii[1]),
          .width = millions(bed),
          .depth = millions(bed),
          .height = millions(150),
          .home_x = millions(bed / 2),
          .home_y = millions(bed / 2),
          .end_stop = {millions(end_stops[0]), millions(end_stops[1])}};
}

// The second one's distal arm is a turn below, the third one nearly stretched, and the last one's
// directions pass half a turn.
inline const std::array<Scara::Parameters, 4> scaras{
    scara({200, 180}, {100, -120}, false, {130, 320}, 200, {100, 215}),
    scara({200, 180}, {100, -120}, true, {130, 320}, 200, {200, -275}),
    scara({500, 400}, {200, -450}, false, {480, 860}, 400, {120, 250}),
    scara({180, 200}, {300, 100}, false, {110, 310}, 200, {220, -30})};

inline double length(units::Nanometers value) { return static_cast<double>(value.count()) * nm; }
inline double radians(double degrees) { return degrees * std::numbers::pi / 180; }

// The tool by the arms' directions in degrees: one arm after the other.
inline std::array<double, 2> tool_of(const Scara::Parameters& each, double first, double second) {
  return {length(each.shoulder_x) + length(each.proximal) * std::cos(radians(first)) +
              length(each.distal) * std::cos(radians(second)),
          length(each.shoulder_y) + length(each.proximal) * std::sin(radians(first)) +
              length(each.distal) * std::sin(radians(second))};
}

// An arm's direction in degrees, of any turn, by the law of cosines.
inline double direction(const Scara::Parameters& each, std::size_t arm, const Vector& tool) {
  const double x = tool[0] - length(each.shoulder_x), y = tool[1] - length(each.shoulder_y);
  const double away = std::hypot(x, y);
  const double here = length(arm == 0 ? each.proximal : each.distal);
  const double other = length(arm == 0 ? each.distal : each.proximal);
  const double off = std::acos((away * away + here * here - other * other) / (2 * away * here));
  const bool adds = (arm == 0) == each.elbow_left;
  return (std::atan2(y, x) + (adds ? off : -off)) * 180 / std::numbers::pi;
}

// How far a place is within the bed and the circles; below 0 outside.
inline double inside(const Scara::Parameters& each, const Vector& tool) {
  const double away =
      std::hypot(tool[0] - length(each.shoulder_x), tool[1] - length(each.shoulder_y));
  return std::min({tool[0], tool[1], length(each.width) - tool[0], length(each.depth) - tool[1],
                   away - length(each.inner_radius), length(each.outer_radius) - away});
}

inline Vector between(const Vector& a, const Vector& b, double part) {
  return {a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1]), a[2] + part * (b[2] - a[2])};
}

class ScaraPlaces : public Places {
 public:
  using Places::Places;
  Place anywhere(const Scara::Parameters& each) {
    return at(within(0, each.width.count()), within(0, each.depth.count()),
              within(0, each.height.count()), 0);
  }
  Place reached_by(const Scara& model) {
    while (true) {
      const Place place = anywhere(model.parameters());
      if (model.straight_within(place, place)) return place;
    }
  }
  // The ends of a line within reach.
  std::array<Place, 2> line_of(const Scara& model) {
    while (true) {
      const Place from = reached_by(model), to = reached_by(model);
      if (model.straight_within(from, to)) return {from, to};
    }
  }
};

}  // namespace motion_test
