// SPDX-License-Identifier: Apache-2.0
// How a job ends before its last line: everything is switched off first, where the printer answers.
#include <utility>

#include "host/feeder/conversation.hpp"

namespace feeder {

namespace {

constexpr std::string_view unknown_heat =
    "the printer does not answer: check that its heaters are off";

}  // namespace

// That the printer says it proves that every line before it was executed.
std::string Conversation::last_word() const {
  return "job " + std::to_string(record()->job) + " ends, " + std::to_string(base_);
}

bool Conversation::is_last_word(std::string_view line) const {
  return has_work() && next_ > length() + 2 && line.ends_with(last_word());
}

void Conversation::end_job(Phase outcome, std::string why) {
  if (record()->phase == Phase::cancelling) {
    return;  // the first reason counts
  }
  Record changed = *record();
  changed.outcome = outcome;
  changed.why = std::move(why);
  begin_closing(std::move(changed));
}

void Conversation::begin_closing(Record record) {
  record.phase = Phase::cancelling;
  typed_.clear();
  journal_.note(record);
  begin_program();
  if (link_ != Link::closed) ask_now();
}

// Lines without a number are all that is left; a printer that hears them may take them.
void Conversation::give_up_closing() {
  output_ += "M104 S0\nM140 S0\n";
  const std::string& why = record()->why;
  set_phase(record()->outcome, (why.empty() ? "" : why + "; ") + std::string(unknown_heat));
}

bool Conversation::may_heat() const {
  return temperatures_.hotend_target.value_or(1) > 0 || temperatures_.bed_target.value_or(0) > 0;
}

std::string Conversation::cancel(std::optional<std::int64_t> job) {
  if (record() && job && record()->job != *job) {
    return "the printer has job " + std::to_string(record()->job);
  }
  if (has_work()) {
    if (record()->phase != Phase::cancelling) {
      end_job(Phase::cancelled, {});
    } else if (link_ == Link::closed) {
      give_up_closing();
    }
    return {};
  }
  if (!job && !may_heat()) return "nothing is being printed";
  if (link_ == Link::closed) return std::string(unknown_heat);
  if (record()) {  // its outcome stays
    Record again = *record();
    again.outcome = again.phase;
    begin_closing(std::move(again));
    return {};
  }
  done_ = 0;
  begin_closing({.job = job.value_or(0),
                 .file = {},
                 .commands = 0,
                 .base = 0,
                 .phase = {},
                 .why = {},
                 .outcome = Phase::cancelled});
  return {};
}

void Conversation::answer_fatal(std::string_view line, Time now) {
  if (has_work()) return end_job(Phase::failed, "the printer says: " + std::string(line));
  typed_.clear();
  ask_now();
  asked_ = now;
}

}  // namespace feeder
