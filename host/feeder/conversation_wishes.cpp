// SPDX-License-Identifier: Apache-2.0
// What people and the spooler ask of a conversation.
#include <algorithm>
#include <charconv>

#include "host/feeder/conversation.hpp"
#include "host/feeder/typed_line.hpp"

namespace feeder {

namespace {

constexpr std::size_t longest_typed_line = 96;
constexpr std::size_t most_typed_lines = 50;

}  // namespace

std::int64_t Conversation::done() const { return record() ? done_ : 0; }

std::string Conversation::start(std::int64_t job, const std::string& file, std::int64_t commands) {
  if (record() && record()->job == job) {
    return {};  // it was asked before
  }
  if (record()) return "job " + std::to_string(record()->job) + " is not forgotten yet";
  if (link_ != Link::ready) return "the printer does not answer";
  if (commands < 1) return "the job has no command";
  try {
    CommandFile(file).at(commands);
  } catch (const std::exception& error) {
    return error.what();
  }
  done_ = 0;
  resends_ = 0;
  journal_.write({.job = job,
                  .file = file,
                  .commands = commands,
                  .base = make_base_(),
                  .phase = Phase::opening,
                  .why = {},
                  .outcome = Phase::cancelled});
  begin_program();
  ask_now();
  return {};
}

std::string Conversation::pause() {
  if (!record() || record()->phase != Phase::running) return "nothing is being printed";
  set_phase(Phase::paused);
  return {};
}

std::string Conversation::resume() {
  if (waits_for_user_ && link_ == Link::ready) {
    output_ += "M108\n";
    ++unanswered_;
  }
  if (!record() || record()->phase != Phase::paused) {
    return waits_for_user_ ? "" : "nothing is paused";
  }
  set_phase(Phase::running);
  return {};
}

std::string Conversation::forget(std::int64_t job) {
  if (!record()) return {};
  if (record()->job != job || !is_over(record()->phase)) {
    return "job " + std::to_string(record()->job) + " is " + std::string(name_of(record()->phase));
  }
  journal_.clear();
  file_.reset();
  return {};
}

std::string Conversation::send(std::string_view text) {
  text = without_blanks(text);
  const bool printable = std::ranges::all_of(text, [](char c) { return c >= ' ' && c <= '~'; });
  if (text.empty() || text.size() > longest_typed_line || !printable) {
    return "a line has 1 to 96 printable characters";
  }
  const std::int64_t code = m_code_of(text);
  if (text.starts_with('N') || text.starts_with('n') || code == 110) {
    return "line numbers are the feeder's";
  }
  if (code == 112) {
    stop_everything();
    return {};
  }
  if (link_ != Link::ready) return "the printer does not answer";
  if (record() && record()->phase != Phase::paused && has_work() && !is_harmless(text)) {
    return "it could spoil the print: pause it first, or wait for its end";
  }
  const bool heats = code == 104 || code == 109 || code == 140 || code == 190;
  if (heats && record() && record()->phase == Phase::cancelling) {
    return "everything is being switched off";
  }
  if (code == 105 || code == 114) {
    asked_codes_.insert(code);
  } else {
    cools_at_.reset();  // a person works on it
  }
  if (code == 108 || code == 410) {  // they act at once
    output_ += "M" + std::to_string(code) + "\n";
    ++unanswered_;
  } else if (typed_.size() < most_typed_lines) {
    typed_.emplace_back(text);
  } else {
    return "too many lines wait";
  }
  say("> " + std::string(text));
  return {};
}

// What the printer asks, at its buttons or in a line of the job.
void Conversation::handle_action(std::string_view action) {
  if (action == "pause") pause();
  if (action == "resume") resume();
  if (action == "cancel" && has_work()) cancel();
  if (action == "prompt_end" || action == "resumed") waits_for_user_ = false;
}

void Conversation::say_if_asked(std::int64_t code, std::string_view line) {
  if (asked_codes_.erase(code) != 0) say(line);
}

void Conversation::stop_everything() {
  output_ = "M112\n";
  homed_.forget();
  typed_.clear();
  say("> M112");
  if (has_work()) set_phase(Phase::failed, "stopped by a person (emergency stop)");
  if (link_ != Link::closed) {
    ask_now();
    asked_ = last_sent_;
  }
}

}  // namespace feeder
