// SPDX-License-Identifier: Apache-2.0
// The bed of the simulated printer as it is: tilted, twisted, and bent in its middle.
#pragma once

#include <algorithm>
#include <array>

namespace machine {

// Millimetres. Heights are above Z = 0, beyond the bed those of its border.
struct BedSurface {
  std::array<double, 2> size{1, 1};  // the travel of X and Y
  double left_front{}, right_front{}, left_back{}, right_back{};
  double middle{};  // above what the corners make of it

  double height(double x, double y) const {
    const double u = std::clamp(x / size[0], 0.0, 1.0), v = std::clamp(y / size[1], 0.0, 1.0);
    const double front = left_front + (right_front - left_front) * u;
    const double back = left_back + (right_back - left_back) * u;
    return front + (back - front) * v + middle * 16 * u * (1 - u) * v * (1 - v);
  }
};

}  // namespace machine
