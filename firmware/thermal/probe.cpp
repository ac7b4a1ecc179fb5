// SPDX-License-Identifier: Apache-2.0
// A small rhythm in the duty of a heater that holds its temperature: a sensor that lives answers
// it.
#include "thermal/probe.hpp"

#include <algorithm>

namespace thermal {
namespace {

// A swing below this percentage of the nominal heater's is no answer: the weakest heater, and the
// controller that works against the rhythm, leave more.
constexpr std::int32_t least_answer = 40;
constexpr int unanswered_sums = 2;

}  // namespace

Duty Probe::modulate(bool settled, Duty duty) {
  if (!settled || !described_ || duty < height || duty > full_duty - height) {
    stop();
    return duty;
  }
  active_ = true;
  const bool up = (window_ + length) % length < length / 2;
  return static_cast<Duty>(up ? duty + height : duty - height);
}

void Probe::stop() {
  active_ = false;
  window_ = -1;
  unanswered_ = 0;
  answer_ = {};
}

bool Probe::is_unanswered(std::int32_t celsius) {
  if (!active_) return false;
  if (window_ < 0) {
    begin_ = celsius;
  } else {
    answer_[static_cast<std::size_t>(window_ % length)] += celsius - begin_;
  }
  if (++window_ < length * periods) return false;
  const auto [lowest, highest] = std::minmax_element(answer_.begin(), answer_.end());
  const std::int32_t swing = (*highest - *lowest) / periods;
  unanswered_ = swing < swing_ * least_answer / 100 ? unanswered_ + 1 : 0;
  answer_ = {};
  window_ = 0;
  return unanswered_ >= unanswered_sums;
}

}  // namespace thermal
