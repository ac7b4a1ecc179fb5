// SPDX-License-Identifier: Apache-2.0
// flock() on a file that is removed again. Its lines: the process, and its note.
#include "tools/files/path_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <sstream>
#include <stdexcept>
#include <system_error>

namespace files {

namespace {

// The same for every spelling of the path. FNV-1a, since a path may be longer than a name.
std::string lock_name(const std::filesystem::path& path) {
  const std::filesystem::path whole = std::filesystem::absolute(path);
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char character :
       (std::filesystem::weakly_canonical(whole.parent_path()) / whole.filename()).string()) {
    hash = (hash ^ static_cast<unsigned char>(character)) * 0x100000001b3;
  }
  return fmt::format("{:016x}.lock", hash);
}

struct Contents {
  std::string process;
  std::string note;
};

Contents contents_of(int file) {
  constexpr std::size_t most = 4096;
  std::array<char, most> bytes;
  const ssize_t count = pread(file, bytes.data(), bytes.size(), 0);
  std::istringstream text(
      std::string(bytes.data(), count > 0 ? static_cast<std::size_t>(count) : 0));
  Contents contents;
  std::getline(text, contents.process);
  std::getline(text, contents.note);
  return contents;
}

}  // namespace

PathLock::PathLock(const std::filesystem::path& path, const std::string& remedy)
    : name_(lock_name(path)) {
  const std::filesystem::path shown = folder_.path() / name_;
  do {
    if (file_ >= 0) close(file_);
    file_ = openat(folder_.descriptor(), name_.c_str(),
                   O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0600);
    if (file_ < 0) throw std::system_error(errno, std::generic_category(), shown.string());
    if (!is_own_file()) {
      close(file_);
      throw std::runtime_error(shown.string() + " is not a lock of this user");
    }
    if (flock(file_, LOCK_EX | LOCK_NB) != 0) {
      const std::string process = contents_of(file_).process;
      close(file_);
      throw std::runtime_error(
          fmt::format("{} is in use by {}{}{}", path.string(),
                      process.empty() ? "another process" : "process " + process,
                      remedy.empty() ? "" : ": ", remedy));
    }
    // Its holder may have removed the file between the two calls.
  } while (!is_in_place());
  note_left_behind_ = contents_of(file_).note;
  try {
    // What was left behind stays until there is something new.
    note(note_left_behind_);
    noted_ = false;
  } catch (...) {
    close(file_);
    throw;
  }
}

PathLock::~PathLock() {
  if (noted_ || note_left_behind_.empty()) unlinkat(folder_.descriptor(), name_.c_str(), 0);
  close(file_);
}

void PathLock::note(const std::string& line) {
  const std::string text = fmt::format("{}\n{}\n", getpid(), line);
  if (ftruncate(file_, 0) != 0 ||
      pwrite(file_, text.data(), text.size(), 0) != static_cast<ssize_t>(text.size())) {
    throw std::system_error(errno, std::generic_category(), (folder_.path() / name_).string());
  }
  noted_ = true;
}

bool PathLock::is_own_file() const {
  struct stat held{};
  return fstat(file_, &held) == 0 && S_ISREG(held.st_mode) && held.st_uid == geteuid() &&
         held.st_nlink <= 1;
}

bool PathLock::is_in_place() const {
  struct stat held{}, named{};
  return fstat(file_, &held) == 0 &&
         fstatat(folder_.descriptor(), name_.c_str(), &named, AT_SYMLINK_NOFOLLOW) == 0 &&
         held.st_dev == named.st_dev && held.st_ino == named.st_ino;
}

}  // namespace files
