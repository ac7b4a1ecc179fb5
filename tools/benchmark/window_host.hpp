// SPDX-License-Identifier: Apache-2.0
// A host that keeps some lines in flight and waits for nothing else: the next line's first bit goes
// out in the clock in which the reply that permits it has been heard.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "sim/devices/serial_line.hpp"

namespace benchmarks {

// Sends lines as they are from the firmware's greeting on, a few of them ahead of their `ok`.
class WindowHost : public devices::ByteListener {
 public:
  // As many as the firmware queues (firmware/host_link/line_queue.hpp).
  static constexpr std::size_t largest_window = 8;

  struct Answer {
    sim::Clock heard_from{};  // the first byte of the `ok` was heard
    sim::Clock heard{};  // its last byte
    sim::Clock sent{};  // all that the host had to send was on the wire, the last time before that
  };

  WindowHost(std::vector<std::string> lines, devices::SerialLine& line,
             std::size_t window = largest_window)
      : lines_(std::move(lines)), line_(line), window_(window) {
    line_.set_listener(*this);
  }

  void byte_received(sim::Clock now, std::uint8_t byte) override {
    if (reply_.empty()) heard_from_ = now;
    if (byte != '\n') {
      reply_ += static_cast<char>(byte);
      return;
    }
    take(now, std::string_view(reply_));
    reply_.clear();
    while (greeted_ && sent_ < lines_.size() && sent_ < answers_.size() + window_) {
      line_.send(now, lines_[sent_++] + "\n");
    }
  }

  void all_sent(sim::Clock now) override { all_sent_ = now; }

  bool done() const { return answers_.size() == lines_.size(); }
  // One for each line that was answered, in their order.
  const std::vector<Answer>& answers() const { return answers_; }
  // Error messages of the chip about a line.
  const std::string& complaint() const { return complaint_; }

 private:
  void take(sim::Clock now, std::string_view reply) {
    if (reply == "start") greeted_ = true;
    if (reply.starts_with("ok")) {
      answers_.push_back({.heard_from = heard_from_, .heard = now, .sent = all_sent_});
    }
    if (reply.starts_with("echo:busy")) {
      return;  // a long move or homing: it will answer
    }
    if (reply.starts_with("Error") || reply.starts_with("echo:")) complaint_ = reply;
  }

  std::vector<std::string> lines_;
  devices::SerialLine& line_;
  std::size_t window_;
  std::string reply_;
  std::string complaint_;
  std::vector<Answer> answers_;
  std::size_t sent_ = 0;
  sim::Clock heard_from_ = 0, all_sent_ = 0;
  bool greeted_ = false;
};

}  // namespace benchmarks
