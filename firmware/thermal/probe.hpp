// SPDX-License-Identifier: Apache-2.0
// A small rhythm in the duty of a heater that holds its temperature: a sensor that
// lives answers it.
#pragma once

#include <cstddef>
#include <cstdint>

#include "thermal/controller.hpp"
#include "thermal/heater_model.hpp"
#include "thermal/rhythm.hpp"
#include "thermal/stillness.hpp"
#include "units/quantity.hpp"

namespace thermal {

// A sensor that froze at the target shows no error, so nothing else finds it. Over the last
// windows the sensor must move by a part of what the rhythm brings by the model: stillness.hpp. The
// halves of the rhythm differ in length, so that no periodic disturbance stays opposite to it.
class Probe {
 public:
  explicit constexpr Probe(const HeaterModel& model)
      : model_(&model), stillness_(2 * model.rhythm.halves[0]) {}

  // `duty` with the rhythm, as far as it has room, while the heater is `settled`.
  Duty modulate(bool settled, Duty duty);
  // With each update: the time since the last one.
  void follow(std::int32_t milliseconds);
  // What the rhythm has added to the sensor's temperature, by the model.
  units::Millicelsius expected_answer() const {
    return units::Millicelsius(answer_ / ProbePath::answer_scale);
  }
  // With each window of the comparison, its mean and its spread in thousandths of a degree, and
  // in mK/s all the heat that the sensor should feel and what the filament takes away: true if
  // the sensor has not answered.
  bool is_unanswered(std::int32_t celsius, std::int32_t spread, std::int32_t heating,
                     std::int32_t melted, std::int32_t milliseconds);
  // With each update between two windows: over longer times.
  bool is_unanswered_for_long() { return stillness_.look_further(); }
  // The fan has changed: what it takes is not known well enough.
  void disturb() { stillness_.disturb(); }

 private:
  void stop();
  void next_window();

  const HeaterModel* model_;
  bool active_ = false;
  bool up_ = true;
  std::size_t half_ = 0;  // of the rhythm
  // The rhythm begins in the middle of its first half, so that its answer swings about 0.
  std::int32_t windows_left_ = model_->rhythm.halves[0] / 2;
  std::int32_t injected_ = 0;  // duty, since the last update
  ProbePath path_;
  std::int32_t answer_ = 0;  // with ProbePath::answer_scale
  std::int32_t answers_ = 0;  // sum of the window under way, in thousandths of a degree
  std::int32_t updates_ = 0;  // in it
  std::int32_t melted_ = 0;  // mK/s, as the sensor feels it
  Stillness stillness_;
};

}  // namespace thermal
