// SPDX-License-Identifier: Apache-2.0
// The course of the rate of a segment with a jerk, in floating point.
#pragma once

#include <algorithm>
#include <cmath>

namespace planning {

// In ticks and clocks; the rate stays above 0.
class Cubic {
 public:
  // As a segment has them: the step generator adds in the order phase, rate, acceleration.
  Cubic(double rate, double acceleration, double jerk)
      : rate_(rate - (acceleration - jerk) / 2 - jerk / 6),
        acceleration_(acceleration - jerk),
        jerk_(jerk) {}

  double ticks(double clocks) const {
    return ((jerk_ / 6 * clocks + acceleration_ / 2) * clocks + rate_) * clocks;
  }
  double rate(double clocks) const { return (jerk_ / 2 * clocks + acceleration_) * clocks + rate_; }
  double highest_acceleration(double clocks) const {
    return std::max(std::abs(acceleration_), std::abs(acceleration_ + jerk_ * clocks));
  }
  double clocks_of(double made) const {
    double low = 0, high = 1;
    // Not far beyond the end of the segment, where the rate may fall below 0.
    while (ticks(high) < made && high < 1e18) low = high, high *= 1.2;
    for (int halvings = 0; halvings < 64; ++halvings) {
      const double middle = (low + high) / 2;
      (ticks(middle) < made ? low : high) = middle;
    }
    return high;
  }

 private:
  double rate_, acceleration_, jerk_;
};

}  // namespace planning
