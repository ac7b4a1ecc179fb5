// SPDX-License-Identifier: Apache-2.0
// A CoreXY by its belts, a delta by Pythagoras.
#include "tests/scenarios/machine_shape.hpp"

#include <cmath>

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

Vector MachineShape::motors_of(const Vector& tool) const {
  const auto [x, y, z] = tool;
  if (kinematics == "core_xy") return {x + y, x - y, z};
  if (kinematics != "delta") return tool;
  Vector motors{};
  for (std::size_t i = 0; i < motors.size(); ++i) {
    motors[i] = z + to_nanometer(carriage_above(i, x, y));
  }
  return motors;
}

// The delta by Newton's method, with the slopes measured.
Vector MachineShape::tool_of(const Vector& motors) const {
  const auto [a, b, c] = motors;
  if (kinematics == "core_xy") return {(a + b) / 2, (a - b) / 2, c};
  if (kinematics != "delta") return motors;
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
