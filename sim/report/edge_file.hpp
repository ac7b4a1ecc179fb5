// SPDX-License-Identifier: Apache-2.0
// Every rising step edge as a row of a CSV file: cycle,axis,direction,position. Whole rows are
// written, so that the file of a job that was killed holds no part of one.
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "sim/devices/step_edge.hpp"

namespace report {

class EdgeFile : public devices::StepListener {
 public:
  // Throws std::runtime_error where the file cannot be written, also for want of room.
  explicit EdgeFile(const std::filesystem::path& file);
  EdgeFile(const EdgeFile&) = delete;
  EdgeFile& operator=(const EdgeFile&) = delete;
  ~EdgeFile() override { flush(); }

  void stepped(const devices::StepEdge& edge) override;
  // All rows so far are in the file.
  void flush();
  // True after a write error.
  bool failed() const { return error_ != 0; }
  // Throws std::runtime_error after a write error.
  void close();

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::filesystem::path path_;
  std::unique_ptr<std::FILE, Close> file_;
  std::string rows_;  // not yet in the file
  int error_ = 0;  // the first, of errno
};

}  // namespace report
