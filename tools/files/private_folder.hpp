// SPDX-License-Identifier: Apache-2.0
// The folder for files of this user's processes that no other user may access.
#pragma once

#include <filesystem>

namespace files {

// An open folder that belongs to this user and that no other user can read or write.
class PrivateFolder {
 public:
  // $XDG_RUNTIME_DIR/stepfabric, and where there is no such folder of this user's own,
  // /tmp/stepfabric-USER with the user's number. Made where it is missing. Throws
  // std::runtime_error where another user's folder, a symlink, or a folder open to
  // others stands there.
  PrivateFolder();
  PrivateFolder(const PrivateFolder&) = delete;
  PrivateFolder& operator=(const PrivateFolder&) = delete;
  ~PrivateFolder();

  const std::filesystem::path& path() const { return path_; }
  // For openat() and its kin.
  int descriptor() const { return descriptor_; }

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
};

}  // namespace files
