// SPDX-License-Identifier: Apache-2.0
// Choice of the replies that a person wants to read.
#include "sim/report/message_log.hpp"

#include <algorithm>

namespace report {

namespace {

// A print that goes wrong line by line shall not fill the memory.
constexpr std::size_t most_messages = 1000;

bool starts_with_any(std::string_view line, std::initializer_list<std::string_view> beginnings) {
  return std::ranges::any_of(beginnings,
                             [&](std::string_view text) { return line.starts_with(text); });
}

}  // namespace

void MessageLog::command_sent(sim::Clock, std::size_t file_line, std::string_view) {
  file_line_ = file_line;
}

void MessageLog::reply(sim::Clock now, std::string_view line) {
  if (starts_with_any(line, {"ok", "echo:busy", "busy:", " T:", "T:"})) {
    return;
  }
  if (messages_.size() >= most_messages) {
    ++dropped_;
    return;
  }
  // The chip's bytes are not under our control, and a report is text.
  std::string text(line);
  std::ranges::replace_if(
      text,
      [](char c) {
        return static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7e;
      },
      '?');
  const bool error = starts_with_any(line, {"Error", "error", "!!", "Resend"});
  messages_.push_back({rate_.seconds(now), file_line_, std::move(text), error});
}

}  // namespace report
