// SPDX-License-Identifier: Apache-2.0
// All checks are made on the open folder, not on its name, which another user could replace.
#include "tools/files/private_folder.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <system_error>

namespace files {

namespace {

constexpr int as_folder = O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC;
constexpr mode_t for_owner_alone = 0700;

bool is_private(int folder) {
  struct stat found{};
  constexpr mode_t for_others = 0077;
  return fstat(folder, &found) == 0 && found.st_uid == geteuid() &&
         (found.st_mode & for_others) == 0;
}

// After `su` the variable may name the folder of the user before.
std::filesystem::path runtime_folder() {
  const char* name = std::getenv("XDG_RUNTIME_DIR");
  if (name == nullptr || *name != '/') return {};
  const int folder = open(name, as_folder);
  if (folder < 0) return {};
  const bool fit = is_private(folder);
  close(folder);
  return fit ? name : std::filesystem::path();
}

std::filesystem::path chosen_path() {
  const std::filesystem::path runtime = runtime_folder();
  if (!runtime.empty()) return runtime / "stepfabric";
  return "/tmp/stepfabric-" + std::to_string(geteuid());
}

}  // namespace

PrivateFolder::PrivateFolder() : path_(chosen_path()) {
  if (mkdir(path_.c_str(), for_owner_alone) != 0 && errno != EEXIST) {
    throw std::system_error(errno, std::generic_category(), path_.string());
  }
  descriptor_ = open(path_.c_str(), as_folder);
  if (descriptor_ >= 0 && is_private(descriptor_)) return;
  if (descriptor_ >= 0) close(descriptor_);
  throw std::runtime_error(path_.string() +
                           " is not a folder that belongs to this user alone (mode 0700): remove "
                           "it, or set XDG_RUNTIME_DIR to one that is");
}

PrivateFolder::~PrivateFolder() { close(descriptor_); }

}  // namespace files
