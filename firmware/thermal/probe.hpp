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
#include "units/quantity.hpp"

namespace thermal {

// A sensor that froze at the target shows no error, so nothing else finds it. Over the last
// windows the sensor must move by a part of what the rhythm alone brings by the model. Noise and
// disturbances add to what it moves; the halves of the rhythm differ in length, so that no
// periodic disturbance stays opposite to it, and where the filament's heat could cancel it there
// is no verdict.
class Probe {
 public:
  explicit constexpr Probe(const HeaterModel& model)
      : model_(&model), merged_(merged_of(model)), height_(height_of(model)) {}

  // `duty` with the rhythm, as far as it has room, while the heater is `settled`.
  Duty modulate(bool settled, Duty duty);
  // With each update: the time since the last one.
  void follow(std::int32_t milliseconds);
  // What the rhythm has added to the sensor's temperature, by the model.
  units::Millicelsius expected_answer() const {
    return units::Millicelsius(answer_ / answer_scale);
  }
  // With each window of the comparison, its mean in thousandths of a degree, and what the filament
  // takes away in mK/s: true if the sensor has not answered.
  bool is_unanswered(std::int32_t celsius, std::int32_t melted, std::int32_t milliseconds);
  // The fan has changed: what it takes is not known well enough.
  void disturb() { undisturbed_ = 0; }

 private:
  // Lengths in windows, each up and then down.
  static constexpr std::array<std::int8_t, 3> halves{3, 2, 4};
  // The rhythm begins in the middle of its first half, so that its answer swings about 0.
  static constexpr int first_windows = halves[0] / 2;
  static constexpr std::size_t length = 18;  // windows of a verdict: one whole rhythm
  static constexpr std::int32_t answer_scale = 16;

  // What the rhythm should bring, in thousandths of a degree from end to end, if two fifths of
  // full power are enough for it.
  static constexpr std::int32_t wanted_swing = 450;
  static constexpr std::int32_t highest = full_duty * 2 / 5;

  struct Window {
    std::int32_t celsius{};  // thousandths
    std::int32_t answer{};  // expected, in thousandths of a degree
    std::int32_t melted{};  // mK that the filament has taken, felt as late as the rhythm
  };

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
  // A window of the rhythm is as many of the comparison as take two fifths of the lags: what is
  // much quicker than those does not come through.
  static constexpr int merged_of(const HeaterModel& model) {
    const auto window = model.window.count();
    const auto wanted = (model.heater_lag + model.sensor_lag).count() * 2 / 5;
    return static_cast<int>(std::max<std::int64_t>((wanted + window / 2) / window, 1));
  }
  static constexpr std::int32_t height_of(const HeaterModel& model) {
    if (model.rise == 0) return 0;
    constexpr int parts = 4;  // steps of a window
    const auto step = static_cast<std::int32_t>(model.window.count()) * merged_of(model) / parts;
    Path path;
    std::int32_t answer = 0, lowest = 0, most = 0;  // answer with answer_scale
    for (int cycle = 0; cycle < 3; ++cycle) {
      for (const std::int8_t half : halves) {
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
  int merged_;  // windows of the comparison in one of the rhythm
  std::int32_t height_;
  bool active_ = false;
  bool up_ = true;
  std::size_t half_ = 0;  // of halves
  int windows_left_ = first_windows;
  std::int32_t injected_ = 0;  // duty, since the last update
  Path path_;
  std::int32_t answer_ = 0;  // with answer_scale
  Window sum_{};  // of the window under way
  int compared_ = 0, updates_ = 0;  // in it
  std::int32_t melted_ = 0;  // mK/s, as the sensor feels it
  std::size_t seen_ = 0;  // windows since the rhythm began, at most `length`, as the following
  std::size_t undisturbed_ = 0;  // since disturb()
  std::size_t still_ = 0;  // in which the sensor has not moved as it must
  std::array<Window, length> windows_{};
};

}  // namespace thermal
