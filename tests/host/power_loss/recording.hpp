// SPDX-License-Identifier: Apache-2.0
// Programs whose work with a folder is recorded, and what is left of it after a loss of power.
#pragma once

#include <cstdint>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "tests/host/power_loss/lossy_disk.hpp"

namespace power_loss {

class Recording {
 public:
  // Programs work in `folder`, made in this one. `fault` is that of the recorder.
  Recording(const std::filesystem::path& place, std::string fault = {});
  ~Recording();
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;

  std::filesystem::path folder() const { return place_ / "disk"; }
  // What is started from now on, by any thread of this process, is recorded.
  void begin();
  // To be called when all these programs have ended.
  std::vector<Record> end();
  // The power is lost after so many operations. Returns what standard outputs had said until then.
  std::string cut(const std::vector<Record>& records, std::size_t operations, std::mt19937& random);

 private:
  std::filesystem::path log() const { return place_ / ("log." + std::to_string(number_)); }

  std::filesystem::path place_;
  std::string fault_;
  int number_ = 0;  // of the log: who is still at work writes to an old one
  LossyDisk disk_;
};

// A number of operations: any, or up to one of a random kind, so that rare ones come as often.
std::size_t random_cut(const std::vector<Record>& records, std::mt19937& random);

}  // namespace power_loss
