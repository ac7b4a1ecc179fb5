// SPDX-License-Identifier: Apache-2.0
// A small rhythm in the duty of a heater that holds its temperature: a sensor that
// lives answers it.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "thermal/controller.hpp"
#include "thermal/heater_model.hpp"
#include "thermal/low_pass.hpp"
#include "thermal/stillness.hpp"
#include "units/quantity.hpp"

namespace thermal {

// A sensor that froze at the target shows no error, so nothing else finds it. Over the last
// windows the sensor must move by a part of what the rhythm brings by the model: stillness.hpp. The
// halves of the rhythm differ in length, so that no periodic disturbance stays opposite to it.
class Probe {
 public:
  explicit constexpr Probe(const HeaterModel& model)
      : model_(&model),
        halves_(halves_of(model)),
        height_(height_of(model)),
        stillness_(2 * halves_[0]) {}

  // `duty` with the rhythm, as far as it has room, while the heater is `settled`.
  Duty modulate(bool settled, Duty duty);
  // With each update: the time since the last one.
  void follow(std::int32_t milliseconds);
  // What the rhythm has added to the sensor's temperature, by the model.
  units::Millicelsius expected_answer() const {
    return units::Millicelsius(answer_ / answer_scale);
  }
  // With each window of the comparison, its mean in thousandths of a degree, and in mK/s all the
  // heat that the sensor should feel and what the filament takes away: true if the sensor has
  // not answered.
  bool is_unanswered(std::int32_t celsius, std::int32_t heating, std::int32_t melted,
                     std::int32_t milliseconds);
  // The fan has changed: what it takes is not known well enough.
  void disturb() { stillness_.disturb(); }

 private:
  // Lengths in windows of the comparison, each up and then down.
  using Halves = std::array<std::int32_t, 3>;
  static constexpr std::int32_t answer_scale = 16;

  // What the rhythm should bring, in thousandths of a degree from end to end, if two fifths of
  // full power are enough for it.
  static constexpr std::int32_t wanted_swing = 540;
  static constexpr std::int32_t highest = full_duty * 2 / 5;

  // The answer to `injected`, one step on.
  struct Path {
    std::int32_t arriving = 0, felt = 0;  // duty, with duty_scale
    constexpr std::int32_t slope(const HeaterModel& model, std::int32_t injected,
                                 std::int32_t milliseconds) {
      arriving = low_pass(arriving, injected * duty_scale, model.heater_lag, milliseconds);
      felt = low_pass(felt, arriving, model.sensor_lag, milliseconds);
      return model.rise * (felt / duty_scale) / full_duty;
    }
  };
  // About four thirds of the lags: what is much quicker does not come through, and what is slower
  // does not show within the windows of a verdict.
  static constexpr Halves halves_of(const HeaterModel& model) {
    const auto lags = static_cast<std::int32_t>((model.heater_lag + model.sensor_lag).count());
    const auto thirds = static_cast<std::int32_t>(model.window.count()) * 3;
    const std::int32_t half = std::max<std::int32_t>((lags * 4 + thirds / 2) / thirds, 3);
    const std::int32_t uneven = std::max<std::int32_t>(half / 8, 1);
    return {half, half - uneven, half + uneven};
  }
  static constexpr std::int32_t height_of(const HeaterModel& model) {
    if (model.rise == 0) return 0;
    constexpr int parts = 4;  // steps of a window
    const auto step = static_cast<std::int32_t>(model.window.count()) / parts;
    Path path;
    std::int32_t answer = 0, lowest = 0, most = 0;  // answer with answer_scale
    for (int cycle = 0; cycle < 3; ++cycle) {
      for (const std::int32_t half : halves_of(model)) {
        for (int i = 0; i < 2 * half * parts; ++i) {
          const std::int32_t injected = i < half * parts ? highest : -highest;
          answer += path.slope(model, injected, step) * step * answer_scale / 1'000;
          if (cycle > 0) lowest = std::min(lowest, answer);
          if (cycle > 0) most = std::max(most, answer);
        }
      }
    }
    const std::int32_t swing = (most - lowest) / answer_scale;
    return swing <= wanted_swing ? highest : highest / 8 * wanted_swing / swing * 8;
  }
  void stop();
  void next_window();

  const HeaterModel* model_;
  Halves halves_;
  std::int32_t height_;
  bool active_ = false;
  bool up_ = true;
  std::size_t half_ = 0;  // of halves_
  // The rhythm begins in the middle of its first half, so that its answer swings about 0.
  std::int32_t windows_left_ = halves_[0] / 2;
  std::int32_t injected_ = 0;  // duty, since the last update
  Path path_;
  std::int32_t answer_ = 0;  // with answer_scale
  std::int32_t answers_ = 0;  // sum of the window under way, in thousandths of a degree
  std::int32_t updates_ = 0;  // in it
  std::int32_t melted_ = 0;  // mK/s, as the sensor feels it
  Stillness stillness_;
};

}  // namespace thermal
