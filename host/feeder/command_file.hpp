// SPDX-License-Identifier: Apache-2.0
// The commands of a job, one a line, read as they are needed: a file of any size in little memory.
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <fstream>
#include <string>

namespace feeder {

class CommandFile {
 public:
  // Throws std::runtime_error where it cannot be read.
  explicit CommandFile(std::filesystem::path file);

  // Command 1 and up. Going on from the last one, or a little back, is quick; elsewhere the file is
  // read from its begin. Throws std::runtime_error where there is no such command, or
  // where it is the last line and has no end: then the file was cut.
  const std::string& at(std::int64_t index);

 private:
  static constexpr std::size_t most_kept = 64;

  std::filesystem::path path_;
  std::ifstream stream_;
  std::deque<std::string> kept_;  // the last ones read
  std::int64_t read_ = 0;  // so many
};

}  // namespace feeder
