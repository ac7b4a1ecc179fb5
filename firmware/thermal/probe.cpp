// SPDX-License-Identifier: Apache-2.0
// A small rhythm in the duty of a heater that holds its temperature: a sensor that
// lives answers it.
#include "thermal/probe.hpp"

#include <algorithm>

namespace thermal {
namespace {

// Less than this percentage of the nominal heater's answer is none. The weakest heater leaves 60 %;
// a disturbance that begins may cancel much of it for a while, but not for twice as long.
constexpr std::int32_t least_answer = 16, least_lasting_answer = 40;
// Thousandths of a degree: a rhythm that has too little room shows nothing.
constexpr std::int32_t least_swing = 100;
// In which what the block itself loses brings an answer back.
constexpr std::int32_t forget_milliseconds = 60'000;

class Range {
 public:
  void add(std::int32_t value) {
    lowest_ = empty_ ? value : std::min(lowest_, value);
    highest_ = empty_ ? value : std::max(highest_, value);
    empty_ = false;
  }
  std::int32_t width() const { return highest_ - lowest_; }

 private:
  bool empty_ = true;
  std::int32_t lowest_ = 0, highest_ = 0;
};

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
  seen_ = still_ = 0;
  up_ = true;
  half_ = 0;
  windows_left_ = first_windows;
}

void Probe::follow(std::int32_t milliseconds) {
  answer_ += path_.slope(*model_, injected_, milliseconds) * milliseconds * answer_scale / 1'000 -
             answer_ * milliseconds / forget_milliseconds;
  sum_.answer += answer_ / answer_scale;
  ++updates_;
}

void Probe::next_window() {
  if (--windows_left_ > 0) return;
  up_ = !up_;
  if (up_) half_ = (half_ + 1) % halves.size();
  windows_left_ = halves[half_];
}

bool Probe::is_unanswered(std::int32_t celsius, std::int32_t melted, std::int32_t milliseconds) {
  melted_ = low_pass(melted_, melted, model_->sensor_lag, milliseconds);
  sum_.celsius += celsius;
  sum_.melted += melted_ * milliseconds / 1'000;
  if (++compared_ < merged_) return false;
  const Window now{sum_.celsius / compared_, sum_.answer / std::max(updates_, 1), sum_.melted};
  sum_ = {};
  compared_ = updates_ = 0;
  std::shift_left(windows_.begin(), windows_.end(), 1);
  windows_.back() = now;
  if (!active_) return false;
  next_window();
  seen_ = std::min(seen_ + 1, length);
  undisturbed_ = std::min(undisturbed_ + 1, length);
  if (seen_ < length) return false;

  std::int32_t mean = 0;
  for (const Window& window : windows_) mean += window.melted;
  mean /= static_cast<std::int32_t>(length);
  // Two windows at a time, for there is noise. What the filament takes may be true, or only half of
  // it, or none, where a nozzle is clogged.
  Range seen, answer, filament, with_half, with_filament;
  std::int32_t taken = 0;
  for (std::size_t i = 1; i < length; ++i) {
    const Window& before = windows_[i - 1];
    const Window& window = windows_[i];
    taken += (before.melted + window.melted) / 2 - mean;
    const std::int32_t both = (before.answer + window.answer) / 2;
    seen.add((before.celsius + window.celsius) / 2);
    answer.add(both);
    filament.add(taken);
    with_half.add(both - taken / 2);
    with_filament.add(both - taken);
  }
  const auto is_still = [&seen](std::int32_t expected, std::int32_t least) {
    return expected >= least_swing && seen.width() < expected * least / 100;
  };
  still_ = is_still(answer.width(), least_lasting_answer) ? still_ + 1 : 0;
  if (still_ >= length) return true;
  return undisturbed_ >= length && filament.width() <= answer.width() &&
         is_still(std::min({answer.width(), with_half.width(), with_filament.width()}),
                  least_answer);
}

}  // namespace thermal
