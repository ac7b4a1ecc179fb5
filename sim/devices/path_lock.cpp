// SPDX-License-Identifier: Apache-2.0
// flock() on a file that is removed again.
#include "sim/devices/path_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>

namespace devices {

namespace {

std::string owner_in(const std::filesystem::path& name) {
  std::ifstream file(name);
  std::string process;
  std::getline(file, process);
  return process.empty() ? "another process" : "process " + process;
}

}  // namespace

PathLock::PathLock(const std::filesystem::path& path) : name_(path.string() + ".lock") {
  do {
    if (file_ >= 0) close(file_);
    file_ = open(name_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    if (file_ < 0) throw std::system_error(errno, std::generic_category(), name_.string());
    if (flock(file_, LOCK_EX | LOCK_NB) != 0) {
      close(file_);
      throw std::runtime_error(path.string() + " is in use by " + owner_in(name_));
    }
    // Whoever had it may have removed the file between the two calls.
  } while (!is_in_place());
  const std::string process = std::to_string(getpid()) + "\n";
  if (ftruncate(file_, 0) != 0 ||
      write(file_, process.data(), process.size()) != static_cast<ssize_t>(process.size())) {
    const int error = errno;
    close(file_);
    throw std::system_error(error, std::generic_category(), name_.string());
  }
}

PathLock::~PathLock() {
  unlink(name_.c_str());
  close(file_);
}

bool PathLock::is_in_place() const {
  struct stat held{}, named{};
  return fstat(file_, &held) == 0 && stat(name_.c_str(), &named) == 0 &&
         held.st_dev == named.st_dev && held.st_ino == named.st_ino;
}

}  // namespace devices
