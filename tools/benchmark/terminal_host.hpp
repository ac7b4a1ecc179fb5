// SPDX-License-Identifier: Apache-2.0
// A host program at the pseudo-terminal of a simulated chip, in a thread of its own as another
// program would be.
#pragma once

#include <atomic>
#include <string>
#include <thread>
#include <vector>

namespace benchmarks {

// Opens the terminal at once, and from the firmware's greeting on sends lines as they are, a few
// of them ahead of their `ok`.
class TerminalHost {
 public:
  static constexpr std::size_t window = 4;

  // Throws std::system_error where the terminal cannot be opened.
  TerminalHost(const std::string& terminal, std::vector<std::string> lines);
  TerminalHost(const TerminalHost&) = delete;
  TerminalHost& operator=(const TerminalHost&) = delete;
  ~TerminalHost();

  // Ends the host: no line is sent and no answer read any more.
  void stop();
  // The firmware has greeted, and the first lines are sent.
  bool greeted() const { return greeted_; }
  // After stop(): error messages of the chip about a line.
  const std::string& complaint() const { return complaint_; }

 private:
  void talk(const std::stop_token& stopped);
  void take(const std::string& reply);
  void send_what_may_be_sent();

  int port_;
  std::vector<std::string> lines_;
  std::size_t sent_ = 0, answered_ = 0;
  std::atomic<bool> greeted_ = false;
  std::string complaint_;
  std::jthread thread_;
};

}  // namespace benchmarks
