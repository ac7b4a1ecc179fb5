// SPDX-License-Identifier: Apache-2.0
// Angles about the centre.
#include "sim/report/arc_shape.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace report {

namespace {

constexpr double turn = 2 * std::numbers::pi;
// Of ends that are the same, but for the rounding of this arithmetic.
constexpr double same_angle = 1e-9;

}  // namespace

std::array<double, 2> ArcShape::at(double part) const {
  const double angle = start_angle + part * sweep;
  const double radius = start_radius + part * (end_radius - start_radius);
  return {centre[0] + radius * std::cos(angle), centre[1] + radius * std::sin(angle)};
}

double ArcShape::part_at(const std::array<double, 2>& place) const {
  const double angle = std::atan2(place[1] - centre[1], place[0] - centre[0]) - start_angle;
  double way = std::copysign(1.0, sweep) * angle;
  way -= turn * std::floor(way / turn);
  const double size = std::abs(sweep);
  if (way <= size) return way / size;
  // Beyond the end, or before the start.
  return way - size < turn - way ? 1 : 0;
}

double ArcShape::distance(const std::array<double, 2>& place) const {
  const auto nearest = at(part_at(place));
  return std::hypot(place[0] - nearest[0], place[1] - nearest[1]);
}

std::vector<double> ArcShape::turning_points() const {
  std::vector<double> parts;
  constexpr double quarter = turn / 4;
  const double low = std::min(start_angle, start_angle + sweep);
  const double high = std::max(start_angle, start_angle + sweep);
  for (double angle = std::ceil(low / quarter) * quarter; angle < high; angle += quarter) {
    parts.push_back((angle - start_angle) / sweep);
  }
  std::ranges::sort(parts);
  return parts;
}

double ArcShape::length_mm() const { return std::abs(sweep) * (start_radius + end_radius) / 2; }

ArcShape arc_about(const std::array<double, 2>& start, const std::array<double, 2>& end,
                   const std::array<double, 2>& offset, bool clockwise) {
  ArcShape arc;
  arc.centre = {start[0] + offset[0], start[1] + offset[1]};
  arc.start_radius = std::hypot(offset[0], offset[1]);
  arc.end_radius = std::hypot(end[0] - arc.centre[0], end[1] - arc.centre[1]);
  arc.start_angle = std::atan2(-offset[1], -offset[0]);
  const double way = std::atan2(end[1] - arc.centre[1], end[0] - arc.centre[0]) - arc.start_angle;
  double size = clockwise ? -way : way;
  size -= turn * std::floor(size / turn);
  if (start == end || size < same_angle) size = turn;
  arc.sweep = clockwise ? -size : size;
  return arc;
}

std::array<double, 2> offset_by_radius(const std::array<double, 2>& start,
                                       const std::array<double, 2>& end, double radius,
                                       bool clockwise) {
  const double x = (end[0] - start[0]) / 2, y = (end[1] - start[1]) / 2;
  const double half = std::hypot(x, y);
  const double height = std::sqrt(std::max(radius * radius - half * half, 0.0)) / half;
  // Left of the way for the smaller part counter-clockwise.
  const double left = clockwise == (radius < 0) ? height : -height;
  return {x - left * y, y + left * x};
}

}  // namespace report
