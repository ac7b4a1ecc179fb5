// SPDX-License-Identifier: Apache-2.0
// Decides what happens to each received line.
#include "host_link/host_link.hpp"

#include <algorithm>

#include "host_link/line_number.hpp"
#include "units/digits.hpp"
#include "units/event_bound.hpp"
#include "units/loop_bound.hpp"
#include "units/text.hpp"

namespace host_link {
namespace {

constexpr units::Milliseconds session_memory{10'000};
// Number of repeated replies to a host that may wait for a lost one; then it is assumed gone
// or finished.
constexpr std::uint8_t rescues = 6;

// Queries that hosts send between numbered lines: safe even as remnants of a line.
bool only_asks(const ReceivedLine& line) {
  switch (line.m_code) {
    case 27:
    case 105:
    case 114:
    case 115:
    case 119:
      return true;
    default:
      return false;
  }
}

// May be executed as far as the link can judge.
bool trusted(const ReceivedLine& line) {
  return !line.corrupted && !line.too_long && (!line.framed() || line.checksum == Checksum::right);
}

// Typed by hand: `M117 5 * 3 = 15`. What is after the last star cannot be a checksum.
bool has_star_in_message(const ReceivedLine& line) {
  if (line.starts_with_n || line.checksum != Checksum::wrong) return false;
  if (!units::starts_with(line.text, "M117") && !units::starts_with(line.text, "M118")) {
    return false;
  }
  const std::string_view rest = line.behind_star;
  units::LoopBound<max_line_length> characters;
  for (const char c : rest) {
    characters.next();
    if (!units::is_digit(c) && c != ' ') return true;
  }
  return rest.empty();
}

// The star and all after it become text.
void drop_checksum(ReceivedLine& line) {
  line.text = {line.text.data(), line.behind_star.data() + line.behind_star.size()};
  line.checksum = Checksum::none;
}

}  // namespace

void HostLink::receive(std::span<const char> bytes, units::Milliseconds now) {
  now_ = now;
  if (bytes.empty()) return;
  give_up_old_line(now);
  last_heard_ = now;
  last_exchange_ = now;
  units::LoopBound<most_bytes> received;
  while (!bytes.empty()) {
    received.next();
    const auto [count, line_ended] = receiver_.put(bytes);
    if (!line_ended) return;
    bytes = bytes.subspan(count);
    handle(receiver_.take());
  }
}

// The line that is given up because of its age is not the broken one.
void HostLink::receive_fault(units::Milliseconds now) {
  give_up_old_line(now);
  receiver_.mark_corrupted();
}

void HostLink::hang_up() {
  receiver_.forget();
  rescues_left_ = 0;
}

void HostLink::handle(ReceivedLine line) {
  // Among numbered lines it may be one that has lost its number.
  if (has_star_in_message(line) && !in_numbered_session()) drop_checksum(line);
  std::optional<EmergencyCommand> emergency;
  if (trusted(line)) emergency = emergency_in(line);
  if (trusted(line) && !emergency && comes_from_a_person(line)) emergency = speed_in(line);
  if (emergency) emergencies_.put(*emergency);
  if (line.torn) {
    if (!line.framed() && !emergency && !line.text.empty() && !only_asks(line)) {
      return notify(Notice::unfinished);
    }
    // In a numbered session this was reported when the line was given up.
    if (rescues_left_ == 0) say("echo:Line not finished, not executed");
  }
  if (line.framed()) {
    handle_framed(line, emergency.has_value());
  } else {
    handle_plain(line, emergency.has_value());
  }
}

void HostLink::handle_plain(const ReceivedLine& line, bool emergency) {
  if (line.corrupted) return notify(Notice::corrupted);
  if (line.too_long) return notify(Notice::too_long);
  if (line.text.empty() || line.text.front() == ';') {
    // A host without line numbers may wait for an answer even to an empty line. Among numbered
    // lines it is a line end that noise has made, and an ok for it would be one too many.
    if (!line.text.empty() || !in_numbered_session()) answer_ok(std::nullopt);
    return;
  }
  if (numbering_.within_patience(now_) && !emergency && !only_asks(line)) {
    // It comes in place of the requested line: it may be its second half.
    if (looks_like_command(line.text)) return notify(Notice::awaiting_resend);
    numbering_.ignored();
    ++statistics_.dropped;
    return;
  }
  if (sets_numbering(line)) {
    if (const auto number = number_set_by(line)) numbering_.restart_after(*number);
  }
  if (answer_ahead(line)) return;
  if (queue_.room() == 0) {
    if (emergency) return answer_ok(std::nullopt);
    return notify(Notice::queue_full);
  }
  accept(line, emergency);
}

void HostLink::framed_line_has_come() {
  framed_seen_ = true;
  last_framed_ = now_;
  last_of_job_ = now_;
  rescues_left_ = rescues;
}

void HostLink::handle_framed_unfinished(const ReceivedLine& line) {
  framed_line_has_come();
  const Judgement judgement = numbering_.judge_broken(line, LineError::unfinished, now_);
  if (judgement.verdict == Verdict::refuse) return request_resend(judgement.error);
  ++statistics_.dropped;
  numbering_.ignored();
}

void HostLink::handle_framed(const ReceivedLine& line, bool emergency) {
  framed_line_has_come();
  const Judgement judgement = numbering_.judge(line, now_);
  switch (judgement.verdict) {
    case Verdict::accept:
      if (line.too_long) {
        // Complete and in order, but too long: accepted, or the host would send it forever.
        numbering_.accepted(line, now_);
        drop_owed_resend();
        return notify(Notice::too_long);
      }
      if (answer_ahead(line)) {
        numbering_.accepted(line, now_);
        return drop_owed_resend();
      }
      if (queue_.room() == 0) {
        if (!line.number) return notify(Notice::queue_full);
        ++statistics_.dropped;
        return request_resend(LineError::none);
      }
      numbering_.accepted(line, now_);
      drop_owed_resend();
      return accept(line, emergency);
    case Verdict::repeat:
      ++statistics_.repeats;
      return answer_ok(line.number);
    case Verdict::refuse:
      return request_resend(judgement.error);
    case Verdict::ignore:
      ++statistics_.dropped;
      return numbering_.ignored();
  }
}

void HostLink::accept(const ReceivedLine& line, bool emergency) {
  ++statistics_.accepted;
  if (queue_.size() == 0) {
    last_busy_ = now_;  // the host's wait begins
  }
  queue_.put(line, emergency);
}

bool HostLink::answer_ahead(const ReceivedLine& line) {
  const std::uint32_t code = line.m_code;
  if (paused_) {
    const bool restarts = code == 110;
    const bool begins = line.number && *line.number <= 1;
    if (restarts || begins || code == 115) {
      say("echo:Paused: M108 goes on, //action:cancel ends");
    }
    if (restarts) {
      answer_ok(line.number);
      return true;
    }
    if (code != 105 && code != 114 && code != 115) return false;
  } else if (code != 105 || queue_.size() == 0 || !comes_from_a_person(line)) {
    return false;
  }
  if (query_count_ == queries_.size()) return false;
  queries_[query_count_++] = static_cast<std::uint8_t>(code);
  return true;
}

std::optional<std::uint8_t> HostLink::query() const {
  return query_count_ != 0 ? std::optional(queries_[0]) : std::nullopt;
}

bool HostLink::query_answered(std::string_view report) {
  if (!put_ok(std::nullopt, report)) return false;
  std::shift_left(queries_.begin(), queries_.end(), 1);
  --query_count_;
  return true;
}

// Hosts number the lines of a job, and send between them without number what a person requests.
bool HostLink::comes_from_a_person(const ReceivedLine& line) const {
  return job_under_way() && !line.framed() && !numbering_.within_patience(now_);
}

bool HostLink::job_under_way() const {
  return framed_seen_ && now_ - last_of_job_ < session_memory;
}

void HostLink::work_goes_on() {
  if (job_under_way()) last_of_job_ = now_;
}

bool HostLink::in_numbered_session() const {
  return framed_seen_ && now_ - last_framed_ < session_memory;
}

std::optional<AcceptedLine> HostLink::next_line() {
  if (in_hand_ || queue_.size() == 0) return std::nullopt;
  in_hand_ = true;
  return queue_.front();
}

bool HostLink::ask_again() {
  if (!in_hand_) return false;
  const AcceptedLine line = queue_.front();
  const std::size_t count = line.number ? queue_.numbered_in_sequence() : 0;
  if (count == 0 || !numbering_.take_back(*line.number, line.text, count)) return false;
  queue_.withdraw_numbered();
  in_hand_ = false;
  drop_withdrawn();
  request_resend(LineError::not_understood);
  return true;
}

void HostLink::drop_withdrawn() {
  units::LoopBound<LineQueue::capacity> withdrawn;
  for (; queue_.front_is_withdrawn(); ++statistics_.withdrawn) {
    withdrawn.next();
    queue_.drop();
  }
}

bool HostLink::finished(std::string_view report) {
  if (!in_hand_) return true;
  const std::optional<LineNumber> number = queue_.front().number;
  if (!put_ok(number, report)) return false;
  queue_.drop();
  drop_withdrawn();
  in_hand_ = false;
  return true;
}

bool HostLink::update(units::Milliseconds now, Activity activity) {
  if (activity != Activity::idle) work_goes_on();
  now_ = now;
  paused_ = activity == Activity::paused_for_user;
  end_unfinished_line();
  if (numbering_.must_ask_again(now) && !resend_owed_) request_resend(LineError::none);
  rescue_waiting_host(activity);
  const bool answers = send_owed();
  keep_alive(activity);
  return answers;
}

}  // namespace host_link
