// SPDX-License-Identifier: Apache-2.0
// What the chip said beyond plain acknowledgements and temperatures, with the time.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "sim/devices/host_listener.hpp"
#include "sim/simulation/clock_rate.hpp"

namespace report {

struct Message {
  double seconds{};
  std::size_t file_line{};  // the command in flight; 0 for none of the file
  std::string text;
  bool error{};
};

class MessageLog : public devices::HostListener {
 public:
  explicit MessageLog(sim::ClockRate rate) : rate_(rate) {}

  void command_sent(sim::Clock now, std::size_t file_line, std::string_view command) override;
  void command_acknowledged(sim::Clock now, std::size_t file_line, std::string_view command,
                            bool executed) override;
  void reply(sim::Clock now, std::string_view line) override;

  const std::vector<Message>& messages() const { return messages_; }
  std::size_t dropped() const { return dropped_; }

 private:
  sim::ClockRate rate_;
  std::deque<std::size_t> in_flight_;  // lines of the file, the one that is worked on first
  std::vector<Message> messages_;
  std::size_t dropped_ = 0;
};

}  // namespace report
