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
  if (!settled || height_ == 0) {
    stop();
    return duty;
  }
  active_ = true;
  const std::int32_t room = std::min<std::int32_t>({height_, duty, full_duty - duty});
  injected_ = up_ ? room : -room;
  return static_cast<Duty>(duty + injected_);
}

void Probe::stop() {
  active_ = false;
  injected_ = 0;
  stillness_.restart();
  up_ = true;
  half_ = 0;
  windows_left_ = halves_[0] / 2;
}

void Probe::follow(std::int32_t milliseconds) {
  answer_ += path_.slope(*model_, injected_, milliseconds) * milliseconds * answer_scale / 1'000 -
             answer_ * milliseconds / forget_milliseconds;
  injected_ = 0;  // unless modulate() is called again
  answers_ += answer_ / answer_scale;
  ++updates_;
}

void Probe::next_window() {
  if (--windows_left_ > 0) return;
  up_ = !up_;
  if (up_) half_ = (half_ + 1) % halves_.size();
  windows_left_ = halves_[half_];
}

bool Probe::is_unanswered(std::int32_t celsius, std::int32_t heating, std::int32_t melted,
                          std::int32_t milliseconds) {
  melted_ = low_pass(melted_, melted, model_->sensor_lag, milliseconds);
  const Stillness::Window window{.celsius = celsius,
                                 .answer = answers_ / std::max<std::int32_t>(updates_, 1),
                                 .given = heating * milliseconds / 1'000,
                                 .taken = melted_ * milliseconds / 1'000};
  answers_ = updates_ = 0;
  if (!active_) return false;
  next_window();
  return stillness_.add(window);
}

}  // namespace thermal
