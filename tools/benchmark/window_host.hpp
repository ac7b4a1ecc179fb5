// SPDX-License-Identifier: Apache-2.0
// A host that keeps several lines in flight, so that the serial line's replies limit nothing.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "sim/devices/serial_line.hpp"

namespace benchmarks {

// Sends lines without numbers from the firmware's greeting on, a few of them ahead of their `ok`.
class WindowHost : public devices::ByteListener {
 public:
  // As many as the firmware takes (firmware/host_link/line_queue.hpp).
  static constexpr std::size_t window = 8;

  WindowHost(std::vector<std::string> lines, devices::SerialLine& line)
      : lines_(std::move(lines)), line_(line) {
    line_.set_listener(*this);
  }

  void byte_received(sim::Clock now, std::uint8_t byte) override {
    if (byte != '\n') {
      reply_ += static_cast<char>(byte);
      return;
    }
    take(std::string_view(reply_));
    reply_.clear();
    while (greeted_ && sent_ < lines_.size() && sent_ < answered_ + window) {
      line_.send(now, lines_[sent_++] + "\n");
    }
  }

  bool done() const { return answered_ == lines_.size(); }
  // What the chip has said against a line.
  const std::string& complaint() const { return complaint_; }

 private:
  void take(std::string_view reply) {
    if (reply == "start") greeted_ = true;
    if (reply.starts_with("ok")) ++answered_;
    if (reply.starts_with("echo:busy")) return;  // a long move or homing: it will answer
    if (reply.starts_with("Error") || reply.starts_with("echo:")) complaint_ = reply;
  }

  std::vector<std::string> lines_;
  devices::SerialLine& line_;
  std::string reply_;
  std::string complaint_;
  std::size_t sent_ = 0;
  std::size_t answered_ = 0;
  bool greeted_ = false;
};

}  // namespace benchmarks
