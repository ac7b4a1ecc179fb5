// SPDX-License-Identifier: Apache-2.0
// The linear heat equations of a heated block, solved exactly over any time.
#include "sim/plants/thermal_path.hpp"

#include <stdexcept>

namespace plants {
namespace {

constexpr std::size_t size = 3;
using Matrix = std::array<HeatState, size>;

HeatState product(const Matrix& matrix, const HeatState& state) {
  HeatState result{};
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) result[i] += matrix[i][j] * state[j];
  }
  return result;
}

Matrix product(const Matrix& left, const Matrix& right) {
  Matrix result{};
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) {
      for (std::size_t k = 0; k < size; ++k) result[i][j] += left[i][k] * right[k][j];
    }
  }
  return result;
}

}  // namespace

ThermalPath::ThermalPath(const ThermalPathProperties& properties, double loss_watts_per_kelvin) {
  const double heater = properties.heater_joules_per_kelvin;
  const double block = properties.block_joules_per_kelvin;
  const double through = properties.heater_to_block_watts_per_kelvin;
  const double lag = properties.sensor_lag_seconds;
  if (!(heater > 0 && block > 0 && through > 0 && lag > 0 && loss_watts_per_kelvin >= 0)) {
    throw std::invalid_argument("a thermal path needs capacities, a conductance and a lag above 0");
  }
  const Matrix rates{{{-through / heater, through / heater, 0},
                      {through / block, -(through + loss_watts_per_kelvin) / block, 0},
                      {0, 1 / lag, -1 / lag}}};
  const HeatState warming{1 / heater, 0, 0};

  // One microsecond is so much shorter than any time constant that the series ends after four
  // terms: exp(A h) = 1 + A h + (A h)^2/2 + ..., and its integral h (1 + A h/2 + (A h)^2/6 + ...).
  constexpr double h = 1e-6;
  constexpr int terms = 4;
  Matrix power{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  Step step{power, {}};
  double h_to_n_by_factorial = 1;
  for (int n = 1; n <= terms; ++n) {
    const HeatState response = product(power, warming);
    h_to_n_by_factorial *= h / n;
    for (std::size_t i = 0; i < size; ++i) step.response[i] += response[i] * h_to_n_by_factorial;
    power = product(power, rates);
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t j = 0; j < size; ++j) {
        step.transition[i][j] += power[i][j] * h_to_n_by_factorial;
      }
    }
  }
  for (Step& doubled : steps_) {
    doubled = step;
    const HeatState carried = product(step.transition, step.response);
    for (std::size_t i = 0; i < size; ++i) step.response[i] += carried[i];
    step.transition = product(step.transition, step.transition);
  }
}

HeatState ThermalPath::after(HeatState state, std::int64_t microseconds, double watts) const {
  if (microseconds < 0) throw std::invalid_argument("time runs backwards");
  for (std::size_t n = 0; n < steps_count; ++n) {
    if ((microseconds >> n & 1) == 0) continue;
    state = product(steps_[n].transition, state);
    for (std::size_t i = 0; i < size; ++i) state[i] += steps_[n].response[i] * watts;
  }
  return state;
}

}  // namespace plants
