// SPDX-License-Identifier: Apache-2.0
// Commands and replies of a host program, passed to listeners.
#include "sim/report/served_host.hpp"

#include <utility>

namespace report {

namespace {

std::string without_comment(const std::string& text) {
  const std::size_t end = text.substr(0, text.find(';')).find_last_not_of(" \t");
  return end == std::string::npos ? std::string() : text.substr(0, end + 1);
}

}  // namespace

void ServedHost::accepted(sim::Clock now, const AcceptedLine& line) {
  ++counts_.lines_sent;
  waiting_.push_back({counts_.lines_sent, without_comment(line.text)});
  if (waiting_.size() == 1) announce(now);
}

void ServedHost::finished(sim::Clock now, bool executed) {
  if (waiting_.empty()) return;
  ++(executed ? counts_.commands_executed : counts_.commands_refused);
  const Command done = std::move(waiting_.front());
  waiting_.pop_front();
  for (devices::HostListener* listener : listeners_) {
    listener->command_acknowledged(now, done.number, done.text, executed);
  }
  if (!waiting_.empty()) announce(now);
}

void ServedHost::withdrawn(sim::Clock now) {
  if (waiting_.empty()) return;
  waiting_.pop_front();
  if (!waiting_.empty()) announce(now);
}

void ServedHost::announce(sim::Clock now) {
  for (devices::HostListener* listener : listeners_) {
    listener->command_sent(now, waiting_.front().number, waiting_.front().text);
  }
}

void ServedHost::heard(sim::Clock now, char byte) {
  // Longer than any reply is only noise.
  constexpr std::size_t longest_reply = 256;
  if (byte != '\n') {
    if (byte != '\r' && reply_.size() < longest_reply) reply_ += byte;
    return;
  }
  const std::string reply = std::exchange(reply_, {});
  if (reply.starts_with("echo:busy")) ++counts_.busy_replies;
  for (devices::HostListener* listener : listeners_) listener->reply(now, reply);
}

}  // namespace report
