// SPDX-License-Identifier: Apache-2.0
// The new file gets a unique name: O_EXCL.
#include "tools/files/write_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <stdexcept>
#include <system_error>

namespace files {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& file, int error) {
  throw std::runtime_error(
      fmt::format("cannot write {}: {}", file.string(), std::generic_category().message(error)));
}

// 0, or the error.
int write_all(int descriptor, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t count = write(descriptor, text.data() + done, text.size() - done);
    if (count < 0 && errno != EINTR) return errno;
    if (count > 0) done += static_cast<std::size_t>(count);
  }
  return 0;
}

int open_new(const fs::path& file, fs::path& name) {
  constexpr unsigned most_tries = 100;
  for (unsigned i = 0; i < most_tries; ++i) {
    name = file.parent_path() / fmt::format(".{}.{}.{}", file.filename().string(), getpid(), i);
    const int descriptor = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor >= 0 || errno != EEXIST) return descriptor;
  }
  return -1;
}

void write_directly(const fs::path& file, const std::string& text) {
  const int descriptor = open(file.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) fail(file, errno);
  const int error = write_all(descriptor, text);
  close(descriptor);
  if (error != 0) fail(file, error);
}

}  // namespace

bool is_foreign_link(const fs::path& file) {
  struct stat found{};
  if (lstat(file.c_str(), &found) != 0 || !S_ISLNK(found.st_mode)) return false;
  return found.st_uid != geteuid() && found.st_uid != 0;
}

void refuse_foreign_link(const fs::path& file) {
  if (!is_foreign_link(file)) return;
  throw std::runtime_error(
      fmt::format("cannot write {}: it is a symlink of another user", file.string()));
}

void write_file(const fs::path& file, const std::string& text) {
  refuse_foreign_link(file);
  std::error_code ignored;
  if (!file.parent_path().empty()) fs::create_directories(file.parent_path(), ignored);
  const fs::file_type type = fs::status(file, ignored).type();
  if (type != fs::file_type::regular && type != fs::file_type::not_found) {
    return write_directly(file, text);
  }
  // Of a symlink the file behind it.
  const fs::path target = type == fs::file_type::regular ? fs::canonical(file) : file;
  fs::path fresh;
  const int descriptor = open_new(target, fresh);
  if (descriptor < 0) fail(file, errno);
  int error = write_all(descriptor, text);
  if (close(descriptor) != 0 && error == 0) error = errno;
  if (error == 0 && std::rename(fresh.c_str(), target.c_str()) != 0) error = errno;
  if (error == 0) return;
  unlink(fresh.c_str());
  fail(file, error);
}

}  // namespace files
