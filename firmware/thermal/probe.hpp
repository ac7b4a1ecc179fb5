// SPDX-License-Identifier: Apache-2.0
// A small rhythm in the duty of a heater that holds its temperature: a sensor that lives answers
// it.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "thermal/controller.hpp"
#include "thermal/heater_model.hpp"
#include "thermal/low_pass.hpp"

namespace thermal {

// A sensor that froze at the target shows no error, so nothing else finds it. The answers of two
// periods are added window by window, which halves what noise and disturbances bring; a sensor that
// moves less than it must in two such sums in a row is frozen. Disturbances only add to the swing.
class Probe {
 public:
  explicit constexpr Probe(const HeaterModel& model)
      : described_(model.rise != 0), swing_(swing_of(model)) {}

  // `duty` with the rhythm, while the heater is `settled` and the duty leaves room for it.
  Duty modulate(bool settled, Duty duty);
  // With each window of the comparison and its mean in thousandths of a degree: true if the sensor
  // has not answered.
  bool is_unanswered(std::int32_t celsius);

 private:
  static constexpr int length = 12;  // windows of a period
  static constexpr int periods = 2;  // of one sum

  // Of full power, up and down. The block of the default machine swings by less than 0.3 K.
  static constexpr std::int32_t height = full_duty * 4 / 100;

  // Of the nominal heater's sensor, in thousandths of a degree, once the rhythm has settled.
  static constexpr std::int32_t swing_of(const HeaterModel& model) {
    constexpr int parts = 4;  // steps of a window
    const auto step = static_cast<std::int32_t>(model.window.count()) / parts;
    std::int32_t arriving = 0, felt = 0, rise = 0, lowest = 0, highest = 0;
    for (int i = 0; i < 3 * length * parts; ++i) {
      const bool up = i / parts % length < length / 2;
      arriving = low_pass(arriving, (up ? height : -height) * duty_scale, model.heater_lag, step);
      felt = low_pass(felt, arriving, model.sensor_lag, step);
      rise += model.rise * (felt / duty_scale) / full_duty * step / 1'000;
      if (i == 2 * length * parts) lowest = highest = rise;
      lowest = std::min(lowest, rise);
      highest = std::max(highest, rise);
    }
    return highest - lowest;
  }
  void stop();

  bool described_;
  std::int32_t swing_;
  bool active_ = false;
  int window_ = -1;  // of the sum under way; -1: the window in which the rhythm began
  int unanswered_ = 0;  // sums in a row
  std::int32_t begin_ = 0;  // temperature
  std::array<std::int32_t, length> answer_{};
};

}  // namespace thermal
