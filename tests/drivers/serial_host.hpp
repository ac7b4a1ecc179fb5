// SPDX-License-Identifier: Apache-2.0
// The other end of a serial line, clock by clock: sends frames (also broken ones) and reads frames.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>

namespace tests {

class SerialHost {
 public:
  // The host's own bit time, which need not be the chip's.
  explicit SerialHost(double clocks_per_bit) : clocks_per_bit_(clocks_per_bit) {}

  void send(std::string_view text) {
    for (const char byte : text) send_frame(static_cast<unsigned char>(byte), true);
  }
  void send_without_stop_bit(char byte) {
    send_frame(static_cast<unsigned char>(byte), false);
    hold(true, 2);
  }
  void send_break(unsigned bits) {
    hold(false, bits);
    hold(true, 2);
  }

  // What the chip has sent, and how many of its frames had no stop bit.
  const std::string& received() const { return received_; }
  unsigned framing_errors() const { return framing_errors_; }
  bool sending() const { return !levels_.empty(); }

  // The level that the chip's next clock sees, given what the chip sends after this one.
  bool clock(bool transmitted) {
    listen(transmitted);
    return drive();
  }

 private:
  void send_frame(unsigned byte, bool stop) {
    hold(false, 1);
    for (unsigned bit = 0; bit < 8; ++bit) hold((byte >> bit & 1) != 0, 1);
    hold(stop, 1);
  }
  void hold(bool level, unsigned bits) { levels_.insert(levels_.end(), bits, level); }

  bool drive() {
    if (levels_.empty()) return true;
    const bool level = levels_.front();
    sent_clocks_ += 1;
    if (sent_clocks_ >= clocks_per_bit_) {
      sent_clocks_ -= clocks_per_bit_;
      levels_.pop_front();
      if (levels_.empty()) sent_clocks_ = 0;
    }
    return level;
  }

  void listen(bool level) {
    if (!listening_) {
      if (level) return;
      listening_ = true;
      heard_clocks_ = 0;
      heard_bits_ = 0;
      heard_ = 0;
    }
    heard_clocks_ += 1;
    if (heard_clocks_ < (heard_bits_ + 0.5) * clocks_per_bit_) return;
    if (heard_bits_ >= 1 && heard_bits_ <= 8) {
      heard_ |= static_cast<unsigned>(level) << (heard_bits_ - 1);
    }
    if (++heard_bits_ < 10) return;
    listening_ = false;
    if (level) {
      received_ += static_cast<char>(heard_);
    } else {
      ++framing_errors_;
    }
  }

  double clocks_per_bit_;
  std::deque<bool> levels_;
  double sent_clocks_ = 0;
  bool listening_ = false;
  double heard_clocks_ = 0;
  unsigned heard_bits_ = 0;
  unsigned heard_ = 0;
  std::string received_;
  unsigned framing_errors_ = 0;
};

}  // namespace tests
