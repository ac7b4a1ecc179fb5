// SPDX-License-Identifier: Apache-2.0
// One direction of a serial line: bytes take time, and some of them are corrupted.
#pragma once

#include <cstdint>
#include <deque>
#include <random>
#include <string>
#include <string_view>

namespace host_link::test {

class NoisyLine {
 public:
  // Of every byte, independently: a flipped bit, another byte, lost, doubled, or
  // one inserted before.
  NoisyLine(double faults_per_byte, std::uint64_t seed)
      : faults_per_byte_(faults_per_byte), random_(seed) {}

  void send(std::string_view bytes);
  // What arrives during one millisecond at 115200 baud.
  std::string arrive_in_a_millisecond();
  bool idle() const { return waiting_.empty(); }
  std::uint32_t faults() const { return faults_; }

 private:
  double faults_per_byte_;
  std::mt19937_64 random_;
  std::deque<char> waiting_;
  std::uint32_t faults_{};
};

}  // namespace host_link::test
