// SPDX-License-Identifier: Apache-2.0
// The course of a G2 or G3 line in floating point, read apart from the firmware.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace report {

// From the start about the centre to the end. Where the end is not on the circle through the start,
// the radius goes evenly from the one to the other.
struct ArcShape {
  std::size_t first{}, second{};  // axes of its plane, 0 = X
  std::array<double, 2> centre{};  // mm, machine
  double start_radius{}, end_radius{};
  double start_angle{};  // from the first towards the second axis
  double sweep{};  // negative: clockwise

  // `part` of the way, 0 to 1.
  std::array<double, 2> at(double part) const;
  // Of the place on the arc that is nearest.
  double part_at(const std::array<double, 2>& place) const;
  double distance(const std::array<double, 2>& place) const;
  // The parts of the way at which one of the axes turns back, in order.
  std::vector<double> turning_points() const;
  double length_mm() const;
};

// `start`, `end`: on the plane's axes; `offset`: from the start to the centre.
ArcShape arc_about(const std::array<double, 2>& start, const std::array<double, 2>& end,
                   const std::array<double, 2>& offset, bool clockwise);
// The offset to the centre of the circle with this radius, of the larger part where it is negative.
std::array<double, 2> offset_by_radius(const std::array<double, 2>& start,
                                       const std::array<double, 2>& end, double radius,
                                       bool clockwise);

}  // namespace report
