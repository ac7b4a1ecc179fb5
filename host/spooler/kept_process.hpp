// SPDX-License-Identifier: Apache-2.0
// A process that goes on when the spooler ends, and is found again by the next one.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "tools/process/process.hpp"

namespace spooler {

class KeptProcess {
 public:
  // `note`: file for its number; its output goes to `log`.
  KeptProcess(std::filesystem::path note, std::filesystem::path log,
              std::vector<std::string> arguments);

  bool is_running() const;
  // Starts it where it does not run, but not twice within some seconds. Throws std::runtime_error.
  void keep_running();
  // Where keep_running() could not write its number. Throws std::runtime_error.
  void write_note();
  void signal(int number) const;

 private:
  std::filesystem::path note_, log_;
  std::vector<std::string> arguments_;
  process::Identity identity_;
  std::chrono::steady_clock::time_point started_at_{};
  bool started_ = false, is_noted_ = true;
};

}  // namespace spooler
