// SPDX-License-Identifier: Apache-2.0
// Choice of the replies that a person wants to read.
#include "sim/report/message_log.hpp"

#include <algorithm>

namespace report {

namespace {

// Bounds the memory of a print that fails in every line.
constexpr std::size_t most_messages = 1000;

bool starts_with_any(std::string_view line, std::initializer_list<std::string_view> beginnings) {
  return std::ranges::any_of(beginnings,
                             [&](std::string_view text) { return line.starts_with(text); });
}

}  // namespace

void MessageLog::command_sent(sim::Clock, std::size_t file_line, std::string_view) {
  in_flight_.push_back(file_line);
}

void MessageLog::command_acknowledged(sim::Clock, std::size_t, std::string_view, bool) {
  if (!in_flight_.empty()) in_flight_.pop_front();
}

void MessageLog::reply(sim::Clock now, std::string_view line) {
  if (starts_with_any(line, {"ok", "echo:busy", "busy:", " T:", "T:"})) return;
  if (messages_.size() >= most_messages) {
    ++dropped_;
    return;
  }
  // The chip may send any bytes, and a report is text.
  std::string text(line);
  std::ranges::replace_if(
      text,
      [](char c) {
        return static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7e;
      },
      '?');
  const bool error = starts_with_any(line, {"Error", "error", "!!", "Resend"});
  const std::size_t file_line = in_flight_.empty() ? 0 : in_flight_.front();
  messages_.push_back({rate_.seconds(now), file_line, std::move(text), error});
}

}  // namespace report
