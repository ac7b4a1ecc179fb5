// SPDX-License-Identifier: Apache-2.0
// Keeps what lies at a path to one process at a time.
#pragma once

#include <filesystem>

namespace devices {

// A locked file beside the path, with the process's number in it. The kernel ends the lock with the
// process, however that ends: a file that is left behind locks nothing.
class PathLock {
 public:
  // Throws std::runtime_error, which names path and process, where another one has the path, or
  // this process has it already; std::system_error where no file can be made there.
  explicit PathLock(const std::filesystem::path& path);
  PathLock(const PathLock&) = delete;
  PathLock& operator=(const PathLock&) = delete;
  ~PathLock();

 private:
  bool is_in_place() const;

  std::filesystem::path name_;
  int file_ = -1;
};

}  // namespace devices
