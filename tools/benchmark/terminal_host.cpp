// SPDX-License-Identifier: Apache-2.0
// Reads replies, and sends the next line where one permits it.
#include "tools/benchmark/terminal_host.hpp"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

namespace benchmarks {

namespace {

constexpr int poll_ms = 20;

}  // namespace

TerminalHost::TerminalHost(const std::string& terminal, std::vector<std::string> lines)
    : port_(open(terminal.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC)), lines_(std::move(lines)) {
  if (port_ < 0) throw std::system_error(errno, std::generic_category(), terminal);
  thread_ = std::jthread([this](const std::stop_token& stopped) { talk(stopped); });
}

TerminalHost::~TerminalHost() {
  stop();
  close(port_);
}

void TerminalHost::stop() {
  thread_.request_stop();
  if (thread_.joinable()) thread_.join();
}

void TerminalHost::talk(const std::stop_token& stopped) {
  std::string reply;
  while (!stopped.stop_requested()) {
    pollfd event{port_, POLLIN, 0};
    if (poll(&event, 1, poll_ms) <= 0) continue;
    std::array<char, 256> buffer;
    const ssize_t count = read(port_, buffer.data(), buffer.size());
    for (ssize_t i = 0; i < count; ++i) {
      const char byte = buffer[static_cast<std::size_t>(i)];
      if (byte != '\n') {
        reply += byte;
        continue;
      }
      take(reply);
      reply.clear();
    }
    send_what_may_be_sent();
  }
}

void TerminalHost::take(const std::string& reply) {
  if (reply == "start") greeted_ = true;
  if (reply.starts_with("ok")) ++answered_;
  if (reply.starts_with("echo:busy")) {
    return;  // a long move or homing: it will answer
  }
  if (reply.starts_with("Error") || reply.starts_with("echo:")) complaint_ = reply;
}

void TerminalHost::send_what_may_be_sent() {
  while (greeted_ && sent_ < lines_.size() && sent_ < answered_ + window) {
    const std::string line = lines_[sent_++] + "\n";
    if (write(port_, line.data(), line.size()) != static_cast<ssize_t>(line.size())) {
      complaint_ = "the terminal takes no line";
    }
  }
}

}  // namespace benchmarks
