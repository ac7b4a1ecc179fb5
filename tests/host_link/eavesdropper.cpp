// SPDX-License-Identifier: Apache-2.0
// Comparing what arrives with what was sent.
#include "tests/host_link/eavesdropper.hpp"

#include <algorithm>

#include "tests/host_link/dialogue.hpp"

namespace host_link::test {
namespace {

// As a receiver may read it: up to three digits after the last '*', perhaps blanks after them.
bool has_right_checksum(const std::string& line) {
  const std::size_t star = line.rfind('*');
  if (star == std::string::npos) return false;
  const std::size_t end = line.find_last_not_of(" \t") + 1;
  const std::string digits = line.substr(star + 1, end - star - 1);
  if (digits.empty() || digits.size() > 3) return false;
  if (digits.find_first_not_of("0123456789") != std::string::npos) return false;
  unsigned sum = 0;
  for (const char c : line.substr(0, star)) sum ^= static_cast<unsigned char>(c);
  return std::stoul(digits) == sum;
}

}  // namespace

std::set<std::string> framed_lines(const std::vector<std::string>& job) {
  std::set<std::string> sent;
  for (int i = 0; i < static_cast<int>(job.size()); ++i) {
    for (const int number : {i, i + 1}) {
      for (const char* separator : {"", " "}) {
        sent.insert(with_checksum("N" + std::to_string(number) + separator +
                                  job[static_cast<std::size_t>(i)] + "*?"));
      }
    }
  }
  for (const char* hello : {"N-1 M110*?", "N0 M110 N0*?", "N0M110*?"}) {
    sent.insert(with_checksum(hello));
  }
  return sent;
}

void Eavesdropper::hear(const std::string& bytes) {
  for (const char c : bytes) {
    if (c != '\n' && c != '\r') {
      line_ += c;
      continue;
    }
    if (has_right_checksum(line_) && !sent_.contains(line_)) unseen_faults_.push_back(line_);
    // The receiver may have begun after the line's start: it gives up what stays unfinished.
    for (std::size_t n = line_.find('N', 1); n != std::string::npos; n = line_.find('N', n + 1)) {
      const std::string line = line_.substr(n);
      if (has_right_checksum(line) && !sent_.contains(line)) unseen_faults_.push_back(line);
    }
    line_.clear();
  }
}

bool Eavesdropper::could_not_be_seen(const std::string& command) const {
  return std::ranges::any_of(unseen_faults_, [&](const std::string& line) {
    return line.find(command) != std::string::npos;
  });
}

}  // namespace host_link::test
