// SPDX-License-Identifier: Apache-2.0
// The linear heat equations of a heated block, solved exactly over any time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace plants {

// Heater, block and sensor, in kelvin above the surroundings.
using HeatState = std::array<double, 3>;

struct ThermalPathProperties {
  double heater_joules_per_kelvin{};
  double heater_to_block_watts_per_kelvin{};
  double block_joules_per_kelvin{};
  double sensor_lag_seconds{};
};

// Between changes of its inputs the path is linear with constant coefficients: x' = A x + b P, so
// that x(t + d) = exp(A d) x(t) + (integral of exp(A s) ds over d) b P. Both are kept for the
// powers of two of a microsecond; any time is a sum of those, so that a step has no error but
// rounding, whatever its length.
class ThermalPath {
 public:
  ThermalPath(const ThermalPathProperties& properties, double loss_watts_per_kelvin);

  HeatState after(HeatState state, std::int64_t microseconds, double watts) const;

 private:
  using Matrix = std::array<HeatState, 3>;  // rows
  struct Step {
    Matrix transition;
    HeatState response;  // to one watt
  };
  static constexpr std::size_t steps_count = 40;  // up to 2^39 us, six days

  std::array<Step, steps_count> steps_;
};

}  // namespace plants
