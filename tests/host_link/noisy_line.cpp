// SPDX-License-Identifier: Apache-2.0
// Faults from a seed.
#include "tests/host_link/noisy_line.hpp"

namespace host_link::test {

void NoisyLine::send(std::string_view bytes) {
  std::uniform_real_distribution<double> chance(0.0, 1.0);
  std::uniform_int_distribution<int> any_byte(0, 255);
  for (const char byte : bytes) {
    if (chance(random_) >= faults_per_byte_) {
      waiting_.push_back(byte);
      continue;
    }
    ++faults_;
    switch (any_byte(random_) % 5) {
      case 0:
        waiting_.push_back(static_cast<char>(byte ^ (1 << (any_byte(random_) % 8))));
        break;
      case 1:
        waiting_.push_back(static_cast<char>(any_byte(random_)));
        break;
      case 2:
        break;
      case 3:
        waiting_.push_back(byte);
        waiting_.push_back(byte);
        break;
      default:
        waiting_.push_back(static_cast<char>(any_byte(random_)));
        waiting_.push_back(byte);
    }
  }
}

std::string NoisyLine::arrive_in_a_millisecond() {
  constexpr std::size_t bytes_per_millisecond = 12;  // 115200 baud, 10 bits a byte
  std::string bytes;
  while (!waiting_.empty() && bytes.size() < bytes_per_millisecond) {
    bytes += waiting_.front();
    waiting_.pop_front();
  }
  return bytes;
}

}  // namespace host_link::test
