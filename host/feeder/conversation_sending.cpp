// SPDX-License-Identifier: Apache-2.0
// Which line is sent next: one is in flight.
#include <utility>

#include "host/feeder/conversation.hpp"

namespace feeder {

namespace {

constexpr Time end_interval{3000};

}  // namespace

void Conversation::send_next(Time now) {
  if (report_at_ && now >= *report_at_) {
    report_at_.reset();
    typed_.emplace_front("M154 S1");
    return put("M155 S2\n", now);
  }
  if (heating_again_ == HeatingAgain::asks) return put("M105\n", now);
  if (!typed_.empty()) {
    homed_.sent(typed_.front());
    put(typed_.front() + "\n", now);
    typed_.pop_front();
    return;
  }
  if (must_heat_again()) return heat_again(now);
  const bool sends =
      has_work() && (record()->phase == Phase::running || record()->phase == Phase::cancelling);
  const bool ends = sends && next_ > length() + 2 && (next_ - length()) % 2 == 1;
  if (sends && (!ends || now - last_sent_ > end_interval)) {
    send_line(now);
  } else if (now - last_sent_ > idle_interval) {
    put("M105\n", now);
  }
}

void Conversation::send_line(Time now) {
  try {
    const std::string text = text_of(next_);
    homed_.sent(text);
    put(framed(base_ + next_, text), now);
    ++next_;
  } catch (const std::exception& error) {  // the file of the commands is damaged
    end_job(Phase::failed, error.what());
  }
}

void Conversation::put(std::string_view text, Time now) {
  output_ += text;
  ++unanswered_;
  last_sent_ = now;
}

std::string Conversation::take_output() { return std::exchange(output_, {}); }

}  // namespace feeder
