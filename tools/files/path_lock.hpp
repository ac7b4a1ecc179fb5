// SPDX-License-Identifier: Apache-2.0
// Locks a path for one process at a time.
#pragma once

#include <filesystem>
#include <string>

#include "tools/files/private_folder.hpp"

namespace files {

// A locked file in this user's private folder, named after the path: nothing is written where the
// path lies. The kernel ends the lock with the process, however that ends: a file that is left
// behind locks nothing. Processes of other users do not see the lock.
class PathLock {
 public:
  // Throws std::runtime_error, which names path, process and remedy, where another one has the
  // path, or this process has it already; std::system_error where no file can be made.
  explicit PathLock(const std::filesystem::path& path, const std::string& remedy = {});
  PathLock(const PathLock&) = delete;
  PathLock& operator=(const PathLock&) = delete;
  ~PathLock();

  // What a process that was killed while it had the path has noted; otherwise empty.
  const std::string& note_left_behind() const { return note_left_behind_; }
  // One line for the process after this one, should this one be killed. Throws std::system_error.
  void note(const std::string& line);

 private:
  bool is_own_file() const;
  bool is_in_place() const;

  PrivateFolder folder_;
  std::string name_;
  std::string note_left_behind_;
  bool noted_ = false;
  int file_ = -1;
};

}  // namespace files
