// SPDX-License-Identifier: Apache-2.0
// A small rhythm in the duty of a heater that holds its temperature: a sensor that
// lives answers it.
#include "thermal/probe.hpp"

#include <algorithm>

namespace thermal {
namespace {

// In which what the block itself loses brings an answer back.
constexpr std::int32_t forget_milliseconds = 60'000;

}  // namespace

Duty Probe::modulate(bool settled, Duty duty) {
  if (!settled || model_->rhythm.height == 0) {
    stop();
    return duty;
  }
  active_ = true;
  const std::int32_t room = std::min<std::int32_t>({model_->rhythm.height, duty, full_duty - duty});
  injected_ = up_ ? room : -room;
  return static_cast<Duty>(duty + injected_);
}

void Probe::stop() {
  active_ = false;
  injected_ = 0;
  stillness_.restart();
  up_ = true;
  half_ = 0;
  windows_left_ = model_->rhythm.halves[0] / 2;
}

void Probe::follow(std::int32_t milliseconds) {
  answer_ +=
      path_.rise(*model_, injected_, milliseconds) - answer_ * milliseconds / forget_milliseconds;
  injected_ = 0;  // unless modulate() is called again
  answers_ += answer_ / ProbePath::answer_scale;
  ++updates_;
}

void Probe::next_window() {
  if (--windows_left_ > 0) return;
  up_ = !up_;
  const auto& halves = model_->rhythm.halves;
  if (up_) half_ = half_ + 1 < halves.size() ? half_ + 1 : 0;
  windows_left_ = halves[half_];
}

bool Probe::is_unanswered(std::int32_t celsius, std::int32_t spread, std::int32_t heating,
                          std::int32_t melted, std::int32_t milliseconds) {
  melted_ = low_pass(melted_, melted, model_->sensor_lag, milliseconds);
  const Stillness::Window window{.celsius = celsius,
                                 .answer = answers_ / std::max<std::int32_t>(updates_, 1),
                                 .given = heating * milliseconds / 1'000,
                                 .taken = melted_ * milliseconds / 1'000,
                                 .spread = spread};
  answers_ = updates_ = 0;
  if (!active_) return false;
  next_window();
  return stillness_.add(window);
}

}  // namespace thermal
