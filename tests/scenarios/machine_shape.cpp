// SPDX-License-Identifier: Apache-2.0
// A CoreXY by its belts, a delta by Pythagoras, a SCARA as two circles that meet in the elbow.
#include "tests/scenarios/machine_shape.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace scenarios {

namespace {

constexpr double nanometers_per_mm = 1e6;

double to_nanometer(double mm) { return std::round(mm * nanometers_per_mm) / nanometers_per_mm; }

}  // namespace

// With the towers at the front left, the front right and the back: half the radius in front of the
// middle, and sqrt(3) / 2 of it to the side.
double MachineShape::carriage_above(std::size_t tower, double x, double y) const {
  const double side = to_nanometer(radius * std::sqrt(3.0) / 2);
  const std::array<std::array<double, 2>, 3> towers{
      {{-side, -radius / 2}, {side, -radius / 2}, {0, radius}}};
  const long double dx = to_nanometer(x) - towers[tower][0];
  const long double dy = to_nanometer(y) - towers[tower][1];
  return static_cast<double>(std::sqrt(static_cast<long double>(rod) * rod - dx * dx - dy * dy));
}

double MachineShape::tool_way() const {
  return kinematics == "scara" ? std::max(arms[0], arms[1]) * std::numbers::pi / 180 : 1;
}

Vector MachineShape::motors_of(const Vector& tool) const {
  const auto [x, y, z] = tool;
  if (kinematics == "core_xy") return {x + y, x - y, z};
  if (kinematics == "scara") return arms_to(tool);
  if (kinematics != "delta") return tool;
  Vector motors{};
  for (std::size_t i = 0; i < motors.size(); ++i) {
    motors[i] = z + to_nanometer(carriage_above(i, x, y));
  }
  return motors;
}

// The elbow is where the circles about shoulder and tool meet.
Vector MachineShape::arms_to(const Vector& tool) const {
  using Point = std::complex<long double>;
  const Point from(shoulder[0], shoulder[1]), to(tool[0], tool[1]);
  const long double away = std::abs(to - from);
  const long double along = (away * away + static_cast<long double>(arms[0]) * arms[0] -
                             static_cast<long double>(arms[1]) * arms[1]) /
                            (2 * away);
  const long double aside =
      std::sqrt(std::max(static_cast<long double>(arms[0]) * arms[0] - along * along, 0.0L));
  const Point elbow = from + (to - from) / away * Point(along, elbow_side * aside);
  const auto direction = [&](const Point& arm, double end_stop) {
    const long double degrees = std::arg(arm) * 180 / std::numbers::pi_v<long double>;
    // Of the turns, that from 350 degrees below the end stop to 10 above it.
    const long double below = end_stop + 10 - degrees;
    return static_cast<double>(end_stop + 10 - (below - 360 * std::floor(below / 360)));
  };
  return {direction(elbow - from, end_stops[0]), direction(to - elbow, end_stops[1]), tool[2]};
}

Vector MachineShape::tool_of(const Vector& motors) const {
  const auto [a, b, c] = motors;
  if (kinematics == "core_xy") return {(a + b) / 2, (a - b) / 2, c};
  if (kinematics == "delta") return tool_delta_holds(motors);
  if (kinematics != "scara") return motors;
  const auto arm = [&](std::size_t i) {
    return std::polar(arms[i], motors[i] * std::numbers::pi / 180);
  };
  const std::complex<double> tool =
      std::complex<double>(shoulder[0], shoulder[1]) + arm(0) + arm(1);
  return {tool.real(), tool.imag(), c};
}

// By Newton's method, with the slopes measured.
Vector MachineShape::tool_delta_holds(const Vector& motors) const {
  const double a = motors[0];
  constexpr double small = 1e-3;
  Vector tool{0, 0, a - carriage_above(0, 0, 0)};
  for (int round = 0; round < 50; ++round) {
    std::array<double, 3> off{}, by_x{}, by_y{};
    for (std::size_t i = 0; i < 3; ++i) {
      const double here = carriage_above(i, tool[0], tool[1]);
      off[i] = motors[i] - tool[2] - here;
      by_x[i] = (carriage_above(i, tool[0] + small, tool[1]) - here) / small;
      by_y[i] = (carriage_above(i, tool[0], tool[1] + small) - here) / small;
    }
    const double x1 = by_x[1] - by_x[0], x2 = by_x[2] - by_x[0];
    const double y1 = by_y[1] - by_y[0], y2 = by_y[2] - by_y[0];
    const double o1 = off[1] - off[0], o2 = off[2] - off[0];
    const double determinant = x1 * y2 - x2 * y1;
    const double x = (o1 * y2 - o2 * y1) / determinant, y = (o2 * x1 - o1 * x2) / determinant;
    tool = {tool[0] + x, tool[1] + y, tool[2] + off[0] - by_x[0] * x - by_y[0] * y};
    if (std::hypot(x, y) < 1e-6) break;
  }
  return tool;
}

}  // namespace scenarios
