// SPDX-License-Identifier: Apache-2.0
// A pause that lasts: the hotend is switched off, since filament chars in it, and heated again
// before the job goes on. The bed stays warm, or the part would come loose.
#include <fmt/format.h>

#include <cmath>

#include "host/feeder/conversation.hpp"

namespace feeder {

namespace {

constexpr Time again_interval{10'000};  // a line without a number may be refused after a Resend
constexpr double same_target = 0.5, nearly_hot = 15;
constexpr const char* hotend_off = "M104 S0";

}  // namespace

void Conversation::note_target() {
  if (temperatures_.hotend_target == reported_target_) target_ = reported_target_;
  reported_target_ = temperatures_.hotend_target;
}

void Conversation::watch_pause(Time now) {
  if (!record() || record()->phase != Phase::paused || pause_limit_ == Time()) {
    cools_at_.reset();
    return;
  }
  if (!cools_at_) cools_at_ = now + pause_limit_;
  const double target = target_.value_or(0);
  // While the printer waits for its user no line is executed: nothing is said that is not done.
  if (target <= 0 || unanswered_ > 0) return;
  const bool is_due = now >= *cools_at_;
  // Where it was switched off before, a person has heated it since.
  const bool is_new = target != hotend_to_restore() && (is_due || hotend_to_restore() > 0);
  if (is_new) note_hotend_to_restore(target);
  if (!is_due) return;
  cools_at_ = now + again_interval;
  if (typed_.empty() || typed_.front() != hotend_off) typed_.emplace_front(hotend_off);
  if (!is_new) {
    return;  // said before
  }
  say(fmt::format("hotend switched off after {} min of pause; resuming the job heats it to {:g} C",
                  std::chrono::duration_cast<std::chrono::minutes>(pause_limit_).count(), target));
}

bool Conversation::must_heat_again() const {
  return hotend_to_restore() > 0 && record()->phase == Phase::running;
}

// The question comes next, whether it was executed: it is repeated until it was.
void Conversation::heat_again(Time now) {
  heating_again_ = HeatingAgain::waits;
  put(fmt::format("M109 S{:g}\n", hotend_to_restore()), now);
}

void Conversation::answer_heating() {
  if (heating_again_ == HeatingAgain::waits) {
    heating_again_ = HeatingAgain::asks;
  } else if (heating_again_ == HeatingAgain::asks) {
    heating_again_ = HeatingAgain::no;
    const double target = temperatures_.hotend_target.value_or(0);
    const bool is_hot = temperatures_.hotend.value_or(0) > hotend_to_restore() - nearly_hot;
    if (is_hot && std::abs(target - hotend_to_restore()) < same_target) note_hotend_to_restore(0);
  }
}

void Conversation::note_hotend_to_restore(double celsius) {
  Record changed = *record();
  changed.hotend_to_restore = celsius;
  journal_.note(changed);
}

}  // namespace feeder
