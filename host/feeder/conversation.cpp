// SPDX-License-Identifier: Apache-2.0
// Where a conversation stands, and how replies move that.
#include "host/feeder/conversation.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace feeder {

namespace {

// Heaters, fan and motors off.
constexpr std::array<std::string_view, 4> closing_lines{"M104 S0", "M140 S0", "M107", "M84"};
// Ends waits and moves at once, ahead of all lines that wait.
constexpr std::string_view cancel_at_once = "//action:cancel\nM108\n";
// No line has such a number: it is refused, and the refusal names the line that is wanted.
constexpr std::int64_t far_ahead = std::int64_t{1} << 29;
// Each crash at the end of a job adds two lines to it.
constexpr std::int64_t most_end_lines = 10'000;
constexpr int most_asks = 8;
constexpr Time settling{300};  // answers to what was asked may still come
constexpr Time resend_ok_limit{1000};  // a firmware may send none
constexpr Time report_delay{3000};  // lines without a number are refused soon after a Resend
constexpr Time retry_interval{1000};  // of the journal

}  // namespace

Conversation::Conversation(Journal& journal, std::function<std::int64_t()> base, Time pause_limit)
    : journal_(journal), make_base_(std::move(base)), pause_limit_(pause_limit) {
  if (has_work()) begin_program();
  if (journal.damage().empty()) return;
  begin_closing({.job = 0,
                 .file = {},
                 .commands = 0,
                 .base = 0,
                 .phase = {},
                 .why = journal.damage(),
                 .outcome = Phase::interrupted});
}

bool Conversation::is_opening() const {
  return record()->phase == Phase::opening ||
         (record()->phase == Phase::cancelling && !numbering_is_set_);
}

void Conversation::set_phase(Phase phase, std::string why) {
  Record changed = *record();
  changed.phase = phase;
  changed.why = std::move(why);
  journal_.note(changed);
}

void Conversation::begin_program() {
  next_ = 1;
  asks_ = 0;
  numbering_is_set_ = false;
  strange_.reset();
  wanted_.reset();
  if (record()->phase == Phase::cancelling) {
    base_ = make_base_();
    return;
  }
  base_ = record()->base;
  try {
    file_ = std::make_unique<CommandFile>(record()->file);
  } catch (const std::exception& error) {
    end_job(Phase::interrupted, error.what());
  }
}

std::int64_t Conversation::length() const {
  return record()->phase == Phase::cancelling ? std::int64_t{closing_lines.size()}
                                              : record()->commands;
}

std::string Conversation::text_of(std::int64_t index) {
  if (index > length()) return (index - length()) % 2 == 1 ? "M400" : "M118 " + last_word();
  if (record()->phase == Phase::cancelling) {
    return std::string(closing_lines.at(static_cast<std::size_t>(index - 1)));
  }
  return file_->at(index);
}

void Conversation::opened(Time now) {
  output_.clear();
  homed_.forget();
  unanswered_ = 0;
  last_answered_ = last_sent_ = now;
  ask_now();
}

void Conversation::closed() {
  link_ = Link::closed;
  position_.reset();
}

void Conversation::ask_now() {
  link_ = Link::asking;
  asked_.reset();
  unanswered_ = 0;
  resend_at_.reset();
}

void Conversation::ask(Time now) {
  asked_ = now;
  if (!has_work()) {
    output_ += "M105\n";
    return;
  }
  const bool closes = record()->phase == Phase::cancelling;
  if ((closes || is_opening()) && ++asks_ > most_asks) {
    if (closes) return give_up_closing();
    return end_job(Phase::failed, "the printer does not take the line numbers");
  }
  if (closes && !numbering_is_set_) output_ += cancel_at_once;
  if (is_opening()) output_ += framed(wanted_.value_or(base_), "M110 N" + std::to_string(base_));
  output_ += framed(base_ + far_ahead, "M105");
}

void Conversation::become_ready(Time now) {
  link_ = Link::ready;
  unanswered_ = 0;
  asks_ = 0;
  last_answered_ = now;
  resend_at_.reset();
  strange_.reset();
  heating_again_ = HeatingAgain::no;
  settled_at_ = now + settling;
  report_at_ = now + report_delay;
}

void Conversation::heard(std::string_view line, Time now) {
  while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
  if (line.empty() || line == "wait") return;
  const bool reports = read_temperatures(line, temperatures_);
  if (reports) {
    note_target();
    say_if_asked(105, line);
  }
  if (line.starts_with("ok")) return answer_ok(now);
  const bool heats = reports && line.find(" W:") != std::string_view::npos;  // a wait for heat
  if (heats || line.find("busy:") != std::string_view::npos) {
    last_answered_ = now;
    asks_ = 0;
  }
  if (reports) return;
  if (const auto position = position_in(line)) {
    position_ = position;
    return say_if_asked(114, line);
  }
  if (const auto number = resend_in(line)) return answer_resend(*number, now);
  if (line.find("busy:") != std::string_view::npos) {
    waits_for_user_ = line.find("paused for") != std::string_view::npos;
    return;
  }
  if (is_last_word(line)) {
    if (record()->phase == Phase::cancelling) return set_phase(record()->outcome, record()->why);
    done_ = record()->commands;
    return set_phase(Phase::finished);
  }
  // What is asked on purpose is refused with a message for people.
  const bool was_asked_for = link_ == Link::asking && line.ends_with(", asked for again");
  if (!was_asked_for) say(line);
  if (is_fatal(line)) return answer_fatal(line, now);
  if (line == "start") {
    homed_.forget();
    return ask_now();
  }
  if (line.starts_with("//")) {
    line.remove_prefix(2);
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    if (line.starts_with("action:")) handle_action(line.substr(7));
  }
}

void Conversation::answer_ok(Time now) {
  waits_for_user_ = false;
  last_answered_ = now;
  if (link_ == Link::asking && !has_work()) return become_ready(now);
  if (link_ != Link::ready) return;
  resend_at_.reset();
  if (unanswered_ > 0) --unanswered_;
  if (unanswered_ == 0) answer_heating();
}

void Conversation::answer_resend(std::int64_t number, Time now) {
  last_answered_ = now;
  if (!has_work()) return;
  if (link_ == Link::asking) return go_on_from(number, now);
  ++resends_;
  const std::int64_t index = number - base_;
  if (index < 1 || index > next_) {
    return ask_now();  // damaged on its way, or a restart
  }
  next_ = index;
  resend_at_ = now;
}

void Conversation::go_on_from(std::int64_t number, Time now) {
  const std::int64_t index = number - base_;
  if (is_opening()) {
    if (index != 1) {
      wanted_ = number;  // the M110 was not taken: again
      return;
    }
    numbering_is_set_ = true;
    if (record()->phase == Phase::opening) {
      // On the disk before the first line leaves, or that line would be sent again after a kill.
      Record running = *record();
      running.phase = Phase::running;
      try {
        journal_.write(running);
      } catch (const std::exception& error) {
        return end_job(Phase::failed, error.what());
      }
    }
    next_ = 1;
    return become_ready(now);
  }
  if (index >= 1 && index <= length() + most_end_lines) {
    next_ = index;
    return become_ready(now);
  }
  // One damaged answer is no reason to give up a print.
  if (strange_ != number) {
    strange_ = number;
    return;
  }
  if (record()->phase == Phase::cancelling) {  // restarted: all of it once more
    begin_program();
    return ask_now();
  }
  end_job(Phase::interrupted,
          "the printer was restarted, or another program used it: it wants line " +
              std::to_string(number) + ", none of this job");
}

void Conversation::update(Time now) {
  if (now - retried_at_ >= retry_interval) {
    retried_at_ = now;
    journal_.retry();
  }
  if (link_ == Link::closed) return;
  watch_pause(now);
  if (link_ == Link::asking) {
    if (!asked_ || now - *asked_ >= ask_interval) ask(now);
    return;
  }
  if (unanswered_ > 0 && now - std::max(last_answered_, last_sent_) > longest_silence) {
    return ask_now();
  }
  if (resend_at_ && now - *resend_at_ > resend_ok_limit) {
    resend_at_.reset();
    unanswered_ = 0;
  }
  if (has_work() && record()->phase != Phase::cancelling) {
    done_ = std::clamp(next_ - 1 - unanswered_, std::int64_t{0}, record()->commands);
  }
  if (unanswered_ == 0 && now >= settled_at_) send_next(now);
}

}  // namespace feeder
