// SPDX-License-Identifier: Apache-2.0
// The host's side of the dialogue with the chip.
#include "sim/devices/file_host.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>

namespace devices {

namespace {

// Marlin says `start` after reset; a firmware that does not is spoken to after this time.
constexpr double start_patience_seconds = 1.0;
// A chip that works on a long command says `busy` every 2 s, so this silence means that it is dead.
constexpr double reply_patience_seconds = 20.0;
// A host sends the line again by itself where `Resend` is not followed by `ok` (OctoPrint: 0.5 s).
constexpr double resend_patience_seconds = 0.5;
// A host gives up where the chip asks so often for one line (OctoPrint: 10).
constexpr unsigned most_resends_of_line = 10;

std::string lower_case(std::string_view text) {
  std::string result(text);
  std::ranges::transform(result, result.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

bool contains_any(const std::string& text, std::initializer_list<std::string_view> words) {
  return std::ranges::any_of(words, [&](std::string_view word) { return text.contains(word); });
}

std::optional<std::size_t> first_number(std::string_view text) {
  const std::size_t begin = text.find_first_of("0123456789");
  if (begin == std::string_view::npos) {
    return std::nullopt;
  }
  std::size_t number = 0;
  const auto result = std::from_chars(text.data() + begin, text.data() + text.size(), number);
  return result.ec == std::errc{} ? std::optional(number) : std::nullopt;
}

std::string numbered_line(std::size_t number, std::string_view command) {
  std::string line = fmt::format("N{} {}", number, command);
  unsigned checksum = 0;
  for (const char character : line) {
    checksum ^= static_cast<std::uint8_t>(character);
  }
  return line + fmt::format("*{}\n", checksum);
}

std::string shortened(const std::string& text) {
  constexpr std::size_t longest = 60;
  return text.size() <= longest ? text : text.substr(0, longest) + "...";
}

}  // namespace

FileHost::FileHost(std::vector<FileCommand> commands, SerialLine& line, sim::ClockRate rate)
    : line_(line), rate_(rate) {
  script_.push_back({0, "M110 N0"});
  std::ranges::move(commands, std::back_inserter(script_));
  script_.push_back({0, "M400"});
  line_.set_listener(*this);
  next_wake_ = rate_.clocks(start_patience_seconds);
}

void FileHost::wake(sim::Clock now) {
  if (ended()) {
    return;
  }
  if (state_ == HostState::waiting_for_start) {
    state_ = HostState::printing;
    send_line(now);
    return;
  }
  if (resend_asked_ && now - resend_asked_at_ >= rate_.clocks(resend_patience_seconds)) {
    resend_asked_ = false;
    send_line(now);
    return;
  }
  if (now - silent_since_ >= rate_.clocks(reply_patience_seconds)) {
    fail(fmt::format("the chip did not answer within {} s to {}", reply_patience_seconds, place()));
    return;
  }
  watch(now);
}

// Asks for the next time at which the host must act although nothing comes from the chip.
void FileHost::watch(sim::Clock) {
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
  if (state_ == HostState::printing) {
    watch(now);
  }
}

void FileHost::take_reply(sim::Clock now, const std::string& reply) {
  if (reply.empty()) {
    return;
  }
  for (HostListener* listener : listeners_) {
    listener->reply(now, reply);
  }
  if (ended()) {
    return;
  }
  const std::string text = lower_case(reply);
  if (state_ == HostState::waiting_for_start) {
    if (text.starts_with("start")) {
      state_ = HostState::printing;
      send_line(now);
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
  } else if (text == "start") {
    fail(fmt::format("the chip restarted during {}", place()));
  } else if (text.starts_with("echo:") && in_flight_) {
    refused_ =
        refused_ || contains_any(text, {"unknown command", "not executed", "invalid extruder"});
  }
}

void FileHost::acknowledge(sim::Clock now) {
  if (!in_flight_) {
    return;
  }
  if (resend_asked_) {
    resend_asked_ = false;
    send_line(now);
    return;
  }
  const FileCommand& command = script_[next_];
  in_flight_ = false;
  resends_of_line_ = 0;
  const bool first_time = next_ >= acknowledged_;
  if (command.file_line != 0 && first_time) {
    ++(refused_ ? counts_.commands_refused : counts_.commands_executed);
  }
  for (HostListener* listener : listeners_) {
    if (first_time) {
      listener->command_acknowledged(now, command.file_line, command.text, !refused_);
    }
  }
  refused_ = false;
  acknowledged_ = std::max(acknowledged_, ++next_);
  if (next_ == script_.size()) {
    state_ = HostState::completed;
  } else {
    send_line(now);
  }
}

void FileHost::ask_again(sim::Clock now, const std::string& reply) {
  const std::optional<std::size_t> number = first_number(reply);
  if (!number || *number >= script_.size() || *number > next_) {
    fail(fmt::format("the chip asks for a line that was never sent: \"{}\"", reply));
    return;
  }
  if (++resends_of_line_ > most_resends_of_line) {
    fail(fmt::format("the chip asked {} times for {}: {}", resends_of_line_, place(),
                     last_error_.empty() ? reply : last_error_));
    return;
  }
  next_ = *number;
  in_flight_ = true;
  resend_asked_ = true;
  resend_asked_at_ = now;
}

// The errors that announce a resend are those that hosts tell apart by these words; others are
// fatal.
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

void FileHost::send_line(sim::Clock now) {
  const FileCommand& command = script_[next_];
  if (next_ < acknowledged_ || resends_of_line_ > 0) {
    ++counts_.resends;
  } else {
    for (HostListener* listener : listeners_) {
      listener->command_sent(now, command.file_line, command.text);
    }
  }
  ++counts_.lines_sent;
  in_flight_ = true;
  line_.send(now, numbered_line(next_, command.text));
  silent_since_ = now;
  watch(now);
}

void FileHost::fail(std::string reason) {
  fault_ = std::move(reason);
  state_ = HostState::faulted;
  next_wake_ = sim::never;
}

std::string FileHost::place() const {
  const FileCommand& command = script_[std::min(next_, script_.size() - 1)];
  if (command.file_line == 0) {
    return fmt::format("the host's \"{}\"", command.text);
  }
  return fmt::format("line {} \"{}\"", command.file_line, shortened(command.text));
}

}  // namespace devices
