// SPDX-License-Identifier: Apache-2.0
// Messages of the link itself: oks, resend requests, notices, busy messages, and their timing.
#include "host_link/host_link.hpp"
#include "host_link/text_line.hpp"
#include "units/event_bound.hpp"
#include "units/loop_bound.hpp"

namespace host_link {
namespace {

// A framed line that pauses is broken: at 9600 baud the gap between two bytes is 1 ms.
constexpr units::Milliseconds framed_line_time_out{300};
// An unnumbered one may be typed by hand: no host rests in a line for more than some 100 ms (at
// 9600 baud a byte takes 1 ms), no person for much longer from key to key, and the host that comes
// next is hardly there sooner.
constexpr units::Milliseconds plain_line_time_out{2000};
constexpr units::Milliseconds rescue_interval{2000};
// Kept free for the link's own replies: the largest, a resend request, has at most 69 bytes.
constexpr std::size_t link_reserve = 96;

constexpr std::uint8_t most_owed = 255;

constexpr std::string_view busy_begin = "echo:busy: ";
constexpr std::string_view longest_reason = "paused for input";
static_assert(busy_begin.size() + longest_reason.size() + 1 == HostLink::longest_busy_message);

void count_up(std::uint8_t& owed, unsigned more) {
  owed = static_cast<std::uint8_t>(owed + more < most_owed ? owed + more : most_owed);
}

std::string_view busy_reason(Activity activity) {
  switch (activity) {
    case Activity::idle:
    case Activity::processing:
      return "processing";
    case Activity::paused_for_user:
      return "paused for user";
    case Activity::paused_for_input:
      return longest_reason;
  }
  return "processing";
}

}  // namespace

std::string_view HostLink::describe(Notice notice) {
  switch (notice) {
    case Notice::too_long:
      return "Line too long, not executed";
    case Notice::corrupted:
      return "Line damaged on the serial line, not executed";
    case Notice::unfinished:
      return "Line not finished, not executed";
    case Notice::queue_full:
      return "Line sent without waiting for ok, not executed";
    case Notice::awaiting_resend:
      return "A damaged line is awaited again, line without number not executed";
  }
  return "";
}

bool HostLink::say(std::string_view line) { return transmit_.put_line({line}, link_reserve); }

bool HostLink::put_ok(std::optional<LineNumber> number, std::string_view report) {
  // A line number, and two numbers of a byte.
  units::EventBound<units::Event::long_digit, 0> numbers;
  units::EventBound<units::Event::digit_written, 10 + 3 + 3> digits;
  TextLine ok;
  ok.text("ok");
  if (advanced_ok_) {
    if (number) ok.text(" N").integer(written(*number));
    ok.text(" P").integer(planner_space_);
    // The slot of the line that is being answered is free again.
    ok.text(" B").integer(static_cast<std::int64_t>(queue_.room() + (in_hand_ ? 1 : 0)));
  }
  if (!transmit_.put_line({ok.view(), report})) return false;
  last_exchange_ = now_;
  last_busy_ = now_;
  return true;
}

void HostLink::answer_ok(std::optional<LineNumber> number) {
  if (put_ok(number, {})) return;
  count_up(oks_owed_, 1);
  owes_ = true;
}

void HostLink::notify(Notice notice) {
  ++statistics_.refused;
  count_up(notices_owed_[static_cast<std::size_t>(notice)], 1);
  owes_ = true;
}

void HostLink::request_resend(LineError error) {
  numbering_.asked_for_resend(now_);
  error_owed_ = error;
  resend_owed_ = true;
  owes_ = true;
  if (queue_.room() == 0) wait_for_room_ = true;
}

// The wanted line has come before there was room to request it.
void HostLink::drop_owed_resend() {
  if (!resend_owed_) return;
  resend_owed_ = false;
  wait_for_room_ = false;
  count_up(oks_owed_, 1);
  owes_ = true;
}

bool HostLink::put_notice(std::size_t index) {
  const std::string_view text = describe(static_cast<Notice>(index));
  if (!transmit_.put_line({"echo:", text})) return false;
  count_up(oks_owed_, notices_owed_[index]);
  notices_owed_[index] = 0;
  return true;
}

bool HostLink::put_resend() {
  // All three lines or none. The first has not the form of an error, since a host may end its print
  // where one byte of that is damaged.
  if (transmit_.room() < link_reserve) return false;
  if (error_owed_ != LineError::none) {
    transmit_.put_line({"echo:", host_link::describe(error_owed_), ", asked for again"});
  }
  units::EventBound<units::Event::long_digit, 0> numbers;
  TextLine resend;
  resend.text("Resend: ").integer(numbering_.asked_for());
  transmit_.put_line({resend.view()});
  transmit_.put_line({"ok"});
  resend_owed_ = false;
  wait_for_room_ = false;
  numbering_.resend_sent(now_);
  last_exchange_ = now_;
  ++statistics_.resends;
  return true;
}

bool HostLink::send_owed() {
  if (!owes_) return false;
  units::happens<units::Event::answered_or_executed>();
  // One of the notices at a time.
  bool notice_sent = false, more_notices = false;
  for (std::size_t index = 0; index < notice_count; ++index) {
    if (notices_owed_[index] == 0) continue;
    more_notices = notice_sent;
    if (notice_sent) break;
    if (!put_notice(index)) return true;
    notice_sent = true;
  }
  // After an overrun the host is asked to go on only when half of the queue is free again.
  const std::size_t room_wanted = wait_for_room_ ? LineQueue::capacity / 2 : 0;
  if (resend_owed_ && queue_.room() >= room_wanted && !put_resend()) return true;
  units::LoopBound<most_oks> oks;
  for (std::size_t i = 0; i < most_oks && oks_owed_ != 0; ++i) {
    oks.next();
    if (!put_ok(std::nullopt, {})) return true;
    --oks_owed_;
  }
  owes_ = resend_owed_ || oks_owed_ != 0 || more_notices;
  return true;
}

void HostLink::end_unfinished_line() {
  if (!receiver_.unfinished()) return;
  const units::Milliseconds silence = now_ - last_heard_;
  if (receiver_.unfinished_is_framed()) {
    if (silence >= framed_line_time_out) handle_framed_unfinished(receiver_.take());
    return;
  }
  if (rescues_left_ == 0 || silence < plain_line_time_out) return;
  receiver_.give_up();
  notify(Notice::unfinished);
}

// An old incomplete line is from a host that has disconnected. Without numbered lines no host waits
// for an answer, so the notice is sent only now.
void HostLink::give_up_old_line(units::Milliseconds now) {
  if (!receiver_.unfinished() || receiver_.unfinished_is_framed()) return;
  if (now - last_heard_ >= plain_line_time_out) receiver_.give_up();
}

// An ok or a Resend may be lost on its way, and a host without time-outs then waits forever.
void HostLink::rescue_waiting_host(Activity activity) {
  const bool idle = activity == Activity::idle && queue_.size() == 0 && !receiver_.unfinished();
  if (!idle || owes_ || rescues_left_ == 0 || now_ - last_exchange_ < rescue_interval) return;
  --rescues_left_;
  if (numbering_.awaiting_resend()) {
    request_resend(LineError::none);
  } else {
    answer_ok(std::nullopt);
  }
}

void HostLink::keep_alive(Activity activity) {
  const bool paused =
      activity == Activity::paused_for_user || activity == Activity::paused_for_input;
  if ((activity == Activity::idle || paused) && queue_.size() == 0) {
    last_busy_ = now_;
    return;
  }
  if (busy_interval_.count() == 0 ||
      now_ - last_busy_ < busy_interval_ - busy_interval_ / busy_lead_part) {
    return;
  }
  if (transmit_.put_line({busy_begin, busy_reason(activity)})) last_busy_ = now_;
}

}  // namespace host_link
