// SPDX-License-Identifier: Apache-2.0
// The host's side of the dialogue with the chip.
#include "sim/devices/file_host.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "sim/devices/host_text.hpp"

namespace devices {

namespace {

// Marlin sends `start` after reset; to a firmware that does not, lines are sent after this time.
constexpr double start_patience_seconds = 1.0;
// A chip that works on a long command says `busy` every 2 s, so this silence means that it is dead.
constexpr double reply_patience_seconds = 20.0;
// A host sends the line again by itself where `Resend` is not followed by `ok` (OctoPrint: 0.5 s).
constexpr double resend_patience_seconds = 0.5;
// A host gives up after this many resend requests for one line (OctoPrint: 10), or for any lines
// without progress.
constexpr unsigned most_resends_of_line = 10;
constexpr unsigned most_resends_without_progress = 100;

}  // namespace

FileHost::FileHost(std::vector<FileCommand> commands, SerialLine& line, sim::ClockRate rate,
                   HostOptions options)
    : line_(line), rate_(rate), options_(std::move(options)) {
  script_.push_back({0, "M110 N0"});
  for (FileCommand& command : commands) {
    if (is_command(command.text, "M110")) {
      options_.note(fmt::format("line {} \"{}\" is not sent: the host numbers the lines itself",
                                command.file_line, shortened(command.text)));
    } else {
      script_.push_back(std::move(command));
    }
  }
  script_.push_back({0, "M400"});
  line_.set_listener(*this);
  next_wake_ = rate_.clocks(start_patience_seconds);
}

void FileHost::wake(sim::Clock now) {
  if (ended()) return;
  if (state_ == HostState::waiting_for_start) {
    state_ = HostState::printing;
    send_lines(now);
    return;
  }
  if (resend_asked_ && now - resend_asked_at_ >= rate_.clocks(resend_patience_seconds)) {
    resend_asked_ = false;
    send_lines(now);
    return;
  }
  if (now - silent_since_ >= rate_.clocks(reply_patience_seconds)) {
    fail(fmt::format("the chip did not answer within {} s to {}", reply_patience_seconds, place()));
    return;
  }
  watch();
}

// Requests the next time at which the host must act although nothing comes from the chip.
void FileHost::watch() {
  next_wake_ = silent_since_ + rate_.clocks(reply_patience_seconds);
  if (resend_asked_) {
    next_wake_ = std::min(next_wake_, resend_asked_at_ + rate_.clocks(resend_patience_seconds));
  }
}

void FileHost::byte_received(sim::Clock now, std::uint8_t byte) {
  silent_since_ = now;
  if (byte == '\n') {
    const std::string reply = std::move(reply_);
    reply_.clear();
    take_reply(now, reply);
  } else if (byte != '\r') {
    reply_ += static_cast<char>(byte);
  }
  if (state_ == HostState::printing) watch();
}

void FileHost::take_reply(sim::Clock now, const std::string& reply) {
  if (reply.empty()) return;
  for (HostListener* listener : listeners_) listener->reply(now, reply);
  if (ended()) return;
  const std::string text = lower_case(reply);
  if (state_ == HostState::waiting_for_start) {
    if (text.starts_with("start")) {
      state_ = HostState::printing;
      send_lines(now);
    }
    return;
  }
  if (text.starts_with("ok")) {
    acknowledge(now);
  } else if (text.starts_with("resend") || text.starts_with("rs ")) {
    ask_again(now, reply);
  } else if (text.starts_with("error") || text.starts_with("!!")) {
    take_error(now, reply);
  } else if (text.starts_with("echo:busy") || text.starts_with("busy:")) {
    ++counts_.busy_replies;
    if (prompt_answered_ && text.contains("paused for user")) {
      line_.send(now, "M108\n");  // the answer was lost
    }
  } else if (text == "start") {
    fail(fmt::format("the chip restarted during {}", place()));
  } else if (text.starts_with("//")) {
    take_action(now, std::string_view(text).substr(2));
  } else if (text.starts_with("echo:") && text.ends_with(", asked for again")) {
    last_error_ = reply;
  } else if (text.starts_with("echo:") && !in_flight_.empty()) {
    refused_ =
        refused_ || contains_any(text, {"unknown command", "not executed", "invalid extruder"});
  }
}

// Action commands with which Marlin's firmware controls the host.
void FileHost::take_action(sim::Clock now, std::string_view action) {
  if (action.contains("action:prompt_show")) {
    answer_prompt(now);
  } else if (action.contains("action:prompt_end")) {
    prompt_answered_ = false;
  } else if (action.contains("action:pause")) {
    options_.note(fmt::format("{} asks the host to pause: the print goes on", place()));
  } else if (action.contains("action:cancel")) {
    fail(fmt::format("{} cancels the print", place()));
  }
}

void FileHost::answer_prompt(sim::Clock now) {
  if (waits_for_a_time(present().text)) {
    options_.note(fmt::format("{} waits for the user: not answered, it ends by itself", place()));
  } else if (options_.answers_prompts) {
    options_.note(fmt::format("{} waits for the user: answered with M108", place()));
    prompt_answered_ = true;
    in_flight_.push_back(std::nullopt);
    line_.send(now, "M108\n");
  } else {
    fail(fmt::format("{} waits for the user, and --no-answer forbids to answer", place()));
  }
}

void FileHost::acknowledge(sim::Clock now) {
  if (resend_asked_) {
    resend_asked_ = false;
    send_lines(now);
    return;
  }
  if (in_flight_.empty()) return;
  const Flight done = in_flight_.front();
  in_flight_.pop_front();
  if (done) acknowledge_line(now, *done);
  refused_ = false;
  if (acknowledged_ == script_.size() && oks_in_doubt_ != 0) {
    --oks_in_doubt_;
    ++own_lines_;
    script_.push_back({0, "M400"});
  }
  if (acknowledged_ == script_.size()) {
    state_ = HostState::completed;
  } else {
    send_lines(now);
  }
}

void FileHost::acknowledge_line(sim::Clock now, std::size_t index) {
  if (index < acknowledged_) {
    return;  // sent a second time
  }
  const FileCommand& command = script_[index];
  acknowledged_ = index + 1;
  resends_of_line_ = resends_without_progress_ = 0;
  counts_.lines_executed += refused_ ? 0 : 1;
  if (command.file_line != 0) ++(refused_ ? counts_.commands_refused : counts_.commands_executed);
  for (HostListener* listener : listeners_) {
    listener->command_acknowledged(now, command.file_line, command.text, !refused_);
  }
}

void FileHost::ask_again(sim::Clock now, const std::string& reply) {
  std::optional<std::size_t> number = first_number(reply);
  // A chip that has not received the M110 has another numbering, so no line after it is
  // sent before.
  if (number && acknowledged_ == 0) number = 0;
  // The next one may be requested, even after the last: a copy of the one before came damaged.
  if (!number || *number > next_) {
    fail(fmt::format("the chip asks for a line that was never sent: \"{}\"", reply));
    return;
  }
  const bool asked_twice = resend_number_ == number;
  if (requested_too_often(*number)) {
    fail(fmt::format("the chip asked {} times for line number {} ({}): {}",
                     resends_without_progress_, *number, place(),
                     last_error_.empty() ? reply : last_error_));
    return;
  }
  // The lines before it will still be answered.
  const std::size_t dropped =
      std::erase_if(in_flight_, [&](const Flight& line) { return line && *line >= *number; });
  if (asked_twice || oks_in_doubt_ != 0) oks_in_doubt_ += dropped;
  next_ = *number;
  resend_asked_ = true;
  resend_asked_at_ = now;
}

bool FileHost::requested_too_often(std::size_t number) {
  resends_of_line_ = number == resend_number_ ? resends_of_line_ + 1 : 1;
  resend_number_ = number;
  return ++resends_without_progress_ > most_resends_without_progress ||
         resends_of_line_ > most_resends_of_line;
}

// The errors that announce a resend are those that hosts distinguish by these words;
// others are fatal.
void FileHost::take_error(sim::Clock, const std::string& reply) {
  last_error_ = reply;
  const std::string text = lower_case(reply);
  if (contains_any(text,
                   {"checksum", "line number", "last line", "expected line", "format error"}) &&
      !text.contains("kill")) {
    return;
  }
  fail(fmt::format("{} (at {})", reply, place()));
}

void FileHost::send_lines(sim::Clock now) {
  // The numbering must have begun before the next lines come.
  const std::size_t window = acknowledged_ == 0 ? 1 : options_.window;
  while (!resend_asked_ && next_ < script_.size() && in_flight_.size() < window) {
    if (is_command(script_[next_].text, "M997")) {
      if (in_flight_.empty()) {
        fail(fmt::format("{} would leave the firmware for its boot loader: not sent", place()));
      }
      break;
    }
    send_line(now, next_++);
  }
  if (!ended()) watch();
}

void FileHost::send_line(sim::Clock now, std::size_t index) {
  const FileCommand& command = script_[index];
  if (index < announced_) {
    ++counts_.resends;
  } else {
    announced_ = index + 1;
    for (HostListener* listener : listeners_) {
      listener->command_sent(now, command.file_line, command.text);
    }
  }
  ++counts_.lines_sent;
  in_flight_.push_back(index);
  line_.send(now, numbered_line(index, command.text));
  silent_since_ = now;
}

void FileHost::fail(std::string reason) {
  fault_ = std::move(reason);
  state_ = HostState::faulted;
  next_wake_ = sim::never;
}

// The command that the chip works on.
const FileCommand& FileHost::present() const {
  const auto line =
      std::ranges::find_if(in_flight_, [](const Flight& flight) { return flight.has_value(); });
  const std::size_t index = line != in_flight_.end() ? **line : next_;
  return script_[std::min(index, script_.size() - 1)];
}

std::string FileHost::place() const { return place_of(present()); }

}  // namespace devices
