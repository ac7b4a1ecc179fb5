// SPDX-License-Identifier: Apache-2.0
// A copy of this process that computes something, and leaves this one as it is.
#pragma once

#include <sys/types.h>

#include <functional>
#include <string>

namespace process {

// For a process with one thread: no other one is in the copy.
class Branch {
 public:
  // Begins at once, with all that is in memory now. SIGINT is left to this process. Throws
  // std::system_error where no process can be made.
  explicit Branch(const std::function<std::string()>& work);
  // Kills the copy where it still runs.
  ~Branch();
  Branch(const Branch&) = delete;
  Branch& operator=(const Branch&) = delete;

  // Waits for what `work` returns. Throws std::runtime_error with what it has thrown, or with how
  // the copy has ended. To be called once.
  std::string result();

 private:
  int end();

  pid_t id_ = 0;
  int pipe_ = -1;
};

}  // namespace process
