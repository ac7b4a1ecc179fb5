// SPDX-License-Identifier: Apache-2.0
// Writes every line that the firmware has accepted: `<number or ->TAB<command>`.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "sim/report/firmware_watch.hpp"

namespace report {

// A byte outside 0x20 .. 0x7e, which only lines without checksum can hold, is written as \xHH.
std::string accept_log_row(const AcceptedLine& line);

class AcceptLog {
 public:
  // Throws std::runtime_error where the file cannot be written.
  explicit AcceptLog(const std::filesystem::path& file);

  // Into the file at once: a program may read it while the printer runs, and a kill leaves it.
  void put(const AcceptedLine& line);
  // True after a write error.
  bool failed() const { return !stream_; }
  // Throws std::runtime_error where the disk did not take all rows.
  void close();

 private:
  std::filesystem::path file_;
  std::ofstream stream_;
};

}  // namespace report
