// SPDX-License-Identifier: Apache-2.0
// The acceptance rules for framed lines; the README lists which host needs which.
#include "host_link/line_numbering.hpp"

#include <algorithm>

#include "units/loop_bound.hpp"

namespace host_link {
std::string_view describe(LineError error) {
  switch (error) {
    case LineError::none:
      return "";
    case LineError::wrong_checksum:
      return "checksum mismatch";
    case LineError::wrong_number:
      return "not the next line number";
    case LineError::no_checksum:
      return "no checksum";
    case LineError::too_long:
      return "line too long";
    case LineError::unprintable:
      return "byte outside ASCII";
    case LineError::unfinished:
      return "line not finished";
    case LineError::corrupted:
      return "serial line disturbed";
    case LineError::not_understood:
      return "not understood";
  }
  return "";
}

LineNumber LineNumbering::wanted() const { return last_ + 1; }

bool LineNumbering::requested_within(units::Milliseconds time, units::Milliseconds now) const {
  return asked_ && now - *asked_ < time;
}

bool LineNumbering::within_patience(units::Milliseconds now) const {
  return awaiting_resend() && requested_within(resend_patience, now);
}

bool LineNumbering::must_ask_again(units::Milliseconds now) const {
  return awaiting_resend() && ignored_since_resend_ && !requested_within(resend_patience, now);
}

Judgement LineNumbering::judge(const ReceivedLine& line, units::Milliseconds now) {
  if (line.corrupted) return judge_broken(line, LineError::corrupted, now);
  if (line.checksum != Checksum::right) {
    if (line.too_long) return judge_broken(line, LineError::too_long, now);
    return judge_broken(
        line, line.checksum == Checksum::none ? LineError::no_checksum : LineError::wrong_checksum,
        now);
  }
  if (line.unprintable) {
    // A line that arrives twice unchanged is not noise: the host sends it on purpose, and the
    // parser decides.
    const Taken seen{line.number.value_or(0), line.fingerprint};
    if (unprintable_ != seen) {
      unprintable_ = seen;
      return judge_broken(line, LineError::unprintable, now);
    }
  }
  // While a line is awaited again, one without a number may be its second half, after a line end
  // that noise has made: one of 256 has the right XOR.
  if (!line.starts_with_n) return {within_patience(now) ? Verdict::ignore : Verdict::accept};
  if (!line.number) return judge_broken(line, LineError::wrong_number, now);
  return judge_number(line, now);
}

// What cannot be the wanted line comes from the host's look-ahead or is a remnant of a line that
// has been requested again: a second Resend for it would send the host back twice.
Judgement LineNumbering::refuse_or_ignore(units::Milliseconds now) const {
  if (within_patience(now)) return {Verdict::ignore};
  return {Verdict::refuse, LineError::wrong_number};
}

Judgement LineNumbering::judge_broken(const ReceivedLine& line, LineError error,
                                      units::Milliseconds now) {
  const bool asked_just_now = within_patience(now);
  if (begins_numbering(line, now)) state_ = State::start_awaited;
  if (asked_just_now && line.number != asked_for()) return {Verdict::ignore};
  refused_number_ = line.number;
  return {Verdict::refuse, error};
}

// A corrupted first line or M110 must be requested as line 0: the number that the old numbering
// wants means nothing to this host, or, worse, another line of its new job.
bool LineNumbering::begins_numbering(const ReceivedLine& line, units::Milliseconds now) const {
  if (!line.number) return false;
  const LineNumber number = *line.number;
  if (!established_ && (number == 0 || number == before_first)) return true;
  if (!sets_numbering(line)) return false;
  const bool is_opening = number == before_first || number <= 1;
  return !established_ || (is_opening && !may_be_sent_back(now));
}

Judgement LineNumbering::judge_number(const ReceivedLine& line, units::Milliseconds now) {
  const LineNumber number = *line.number;
  if (sets_numbering(line)) return judge_restart(line, now);
  switch (state_) {
    case State::in_order:
      break;
    case State::line_awaited:
      if (start_may_be_lost(line)) return judge_after_lost_start(now);
      break;
    case State::start_awaited:
      if (number != asked_for() && within_patience(now)) return {Verdict::ignore};
      break;
  }
  if (number == wanted()) return {Verdict::accept};
  if (number == 0 || number == 1) return judge_first_number(line, now);
  if (taken_before(number, line.fingerprint)) return {Verdict::repeat};
  return refuse_or_ignore(now);
}

// In the middle of a job it is more likely a host that was sent back, or a fault that the
// XOR missed.
Judgement LineNumbering::judge_after_lost_start(units::Milliseconds now) {
  if (established_ && now - last_taken_ < restart_pause) return refuse_or_ignore(now);
  const bool asked_for_it = asked_for() == 0;
  state_ = State::start_awaited;
  if (asked_for_it) return refuse_or_ignore(now);
  return {Verdict::refuse, LineError::wrong_number};
}

// A Resend whose number was corrupted on its way can send a host back to the M110 that
// opened its job.
bool LineNumbering::may_be_sent_back(units::Milliseconds now) const {
  return state_ == State::line_awaited && history_size_ != 0 &&
         requested_within(restart_pause, now);
}

Judgement LineNumbering::judge_restart(const ReceivedLine& line, units::Milliseconds now) const {
  if (*line.number == wanted()) return {Verdict::accept};
  // printcore's N-1 is sent once and never again.
  if (*line.number != before_first && may_be_sent_back(now)) return refuse_or_ignore(now);
  return {Verdict::accept};
}

// N0 or N1 out of order: a new numbering, of which the M110 is lost or was never sent.
Judgement LineNumbering::judge_first_number(const ReceivedLine& line,
                                            units::Milliseconds now) const {
  const std::uint32_t fingerprint = line.fingerprint;
  const bool taken = taken_before(*line.number, fingerprint);
  // The same opening again, after a pause: the same job started again, unless a Resend whose number
  // was corrupted on its way explains it.
  const bool explained = requested_within(resend_memory, now) || now - last_taken_ < restart_pause;
  const bool known = taken || opened_with(*line.number, fingerprint);
  if (looks_like_command(line.text) && !(known && explained)) return {Verdict::accept};
  if (taken) return {Verdict::repeat};
  return refuse_or_ignore(now);
}

// An unknown N1 while a line that could not be read is awaited: that line may have been N0, without
// which nothing must begin.
bool LineNumbering::start_may_be_lost(const ReceivedLine& line) const {
  if (line.number != 1 || refused_number_ == 1) return false;
  if (established_ && wanted() == 1) return false;
  return !opened_with(1, line.fingerprint);
}

void LineNumbering::accepted(const ReceivedLine& line, units::Milliseconds now) {
  if (!line.number) return;
  last_taken_ = now;
  if (sets_numbering(line)) return restart_after(number_set_by(line).value_or(*line.number));
  const LineNumber number = *line.number;
  const std::uint32_t fingerprint = line.fingerprint;
  if (number != wanted()) forget();
  if (number == 0 || number == 1) openings_[static_cast<std::size_t>(number)] = fingerprint;
  history_[history_next_] = {number, fingerprint};
  history_next_ = (history_next_ + 1) % history_length;
  if (history_size_ < history_length) ++history_size_;
  last_ = number;
  end_recovery();
}

bool LineNumbering::take_back(LineNumber number, std::string_view text, std::size_t count) {
  const Taken line{number, fingerprint_of(text)};
  if (taken_back_ == line || history_size_ < count ||
      number + static_cast<LineNumber>(count) != wanted()) {
    return false;
  }
  taken_back_ = line;
  refused_number_ = number;
  last_ = number - 1;
  history_size_ -= count;
  history_next_ = (history_next_ + history_length - count) % history_length;
  return true;
}

void LineNumbering::restart_after(LineNumber last) {
  forget();
  last_ = last;
  end_recovery();
}

void LineNumbering::end_recovery() {
  established_ = true;
  state_ = State::in_order;
  unprintable_.reset();
  refused_number_.reset();
  lost_start_asked_ = 0;
}

void LineNumbering::asked_for_resend(units::Milliseconds now) {
  asked_ = now;
  if (state_ == State::in_order) state_ = State::line_awaited;
  ignored_since_resend_ = false;
}

void LineNumbering::resend_sent(units::Milliseconds now) {
  asked_for_resend(now);
  if (state_ != State::start_awaited || ++lost_start_asked_ <= lost_start_requests) return;
  // It begins at N1, which may come now.
  state_ = State::line_awaited;
  refused_number_ = 1;
}

bool LineNumbering::taken_before(LineNumber number, std::uint32_t fingerprint) const {
  units::LoopBound<history_length> bound;
  for (std::size_t i = 0; i < history_size_; ++i) {
    bound.next();
    if (history_[i] == Taken{number, fingerprint}) return true;
  }
  return false;
}

bool LineNumbering::opened_with(LineNumber number, std::uint32_t fingerprint) const {
  return openings_[static_cast<std::size_t>(number)] == fingerprint;
}

void LineNumbering::forget() {
  history_size_ = 0;
  history_next_ = 0;
  openings_ = {};
}

}  // namespace host_link
