// SPDX-License-Identifier: Apache-2.0
// The probe's rhythm for a heater: how long it gets more and less heat, and how much. Found by the
// compiler, for it takes a simulation.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "thermal/controller.hpp"
#include "thermal/heater_properties.hpp"
#include "thermal/low_pass.hpp"

namespace thermal {

struct Rhythm {
  // Lengths in windows of the comparison, each up and then down. They differ, so that no periodic
  // disturbance stays opposite to them.
  std::array<std::int32_t, 3> halves{};
  std::int32_t height{};  // duty; 0: no probe
};

// What injected duty brings to the sensor, step by step.
struct ProbePath {
  static constexpr std::int32_t answer_scale = 16;

  std::int32_t arriving = 0, felt = 0;  // duty, with duty_scale
  // In thousandths of a degree, with answer_scale.
  constexpr std::int32_t rise(const HeaterProperties& heater, std::int32_t injected,
                              std::int32_t milliseconds) {
    arriving = low_pass(arriving, injected * duty_scale, heater.heater_lag, milliseconds);
    felt = low_pass(felt, arriving, heater.sensor_lag, milliseconds);
    const std::int32_t slope = heater.rise * (felt / duty_scale) / full_duty;
    return slope * milliseconds * answer_scale / 1'000;
  }
};

constexpr Rhythm rhythm_of(const HeaterProperties& heater) {
  // What it should bring, in thousandths of a degree from end to end, if two fifths of full power
  // are enough for it.
  constexpr std::int32_t wanted_swing = 540, highest = full_duty * 2 / 5;
  const auto window = static_cast<std::int32_t>(heater.window.count());
  // About four thirds of the lags: what is much quicker does not come through, and what is slower
  // does not show within the windows of a verdict.
  const auto lags = static_cast<std::int32_t>((heater.heater_lag + heater.sensor_lag).count());
  const std::int32_t half = std::max<std::int32_t>((lags * 4 + window * 3 / 2) / (window * 3), 3);
  const std::int32_t uneven = std::max<std::int32_t>(half / 8, 1);
  Rhythm rhythm{.halves = {half, half - uneven, half + uneven}};
  if (heater.rise == 0) return rhythm;

  constexpr int parts = 4;  // steps of a window
  ProbePath path;
  std::int32_t answer = 0, lowest = 0, most = 0;  // with answer_scale
  for (int cycle = 0; cycle < 3; ++cycle) {
    for (const std::int32_t length : rhythm.halves) {
      for (int i = 0; i < 2 * length * parts; ++i) {
        answer += path.rise(heater, i < length * parts ? highest : -highest, window / parts);
        if (cycle > 0) lowest = std::min(lowest, answer);
        if (cycle > 0) most = std::max(most, answer);
      }
    }
  }
  const std::int32_t swing = (most - lowest) / ProbePath::answer_scale;
  rhythm.height = swing <= wanted_swing ? highest : highest / 8 * wanted_swing / swing * 8;
  return rhythm;
}

}  // namespace thermal
