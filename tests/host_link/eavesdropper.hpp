// SPDX-License-Identifier: Apache-2.0
// Finds lines that no receiver can recognise as corrupted: with a correct checksum, but never sent
// by the host.
#pragma once

#include <set>
#include <string>
#include <vector>

namespace host_link::test {

// Every framed line that one of the hosts sends for this job, its greeting included.
std::set<std::string> framed_lines(const std::vector<std::string>& job);

// Listens behind the noise. The lines as they reach the link, cut at any line end.
class Eavesdropper {
 public:
  explicit Eavesdropper(std::set<std::string> sent) : sent_(std::move(sent)) {}

  void hear(const std::string& bytes);
  // Is this command in a line that was delivered with a right checksum, but never sent so?
  bool could_not_be_seen(const std::string& command) const;
  std::size_t unseen_faults() const { return unseen_faults_.size(); }

 private:
  std::set<std::string> sent_;
  std::vector<std::string> unseen_faults_;
  std::string line_;
};

}  // namespace host_link::test
