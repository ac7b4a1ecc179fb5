// SPDX-License-Identifier: Apache-2.0
// A library for LD_PRELOAD: writes down, in their order, what a program and its children do with
// the files below a folder. Nothing is really synchronised.
//   RECORDER_FOLDER  files below it are recorded
//   RECORDER_LOG     outside of it: one record after the other, of all processes
//   RECORDER_FAULT   what the program is made to do wrong: no_file_sync, no_folder_sync,
//                    no_database_sync, rename_first (before the file is synchronised),
//                    folder_sync_error (the disk refuses it)
// What is done by stdio is recorded when its file is synchronised by a descriptor for reading.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "tests/host/power_loss/disk_record.hpp"

namespace {

using power_loss::Head;
using power_loss::Kind;

constexpr std::size_t most_descriptors = 4096;
// By descriptor: the inode of a recorded file.
std::array<std::atomic<std::uint64_t>, most_descriptors> inodes{};

std::string variable(const char* name) {
  const char* text = std::getenv(name);
  return text == nullptr ? std::string() : text;
}
const std::string& folder() {
  static const std::string text = variable("RECORDER_FOLDER");
  return text;
}
const std::string& fault() {
  static const std::string text = variable("RECORDER_FAULT");
  return text;
}
int log_file() {
  static const int file = [] {
    const std::string name = variable("RECORDER_LOG");
    return static_cast<int>(syscall(SYS_openat, AT_FDCWD, name.c_str(),
                                    O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600));
  }();
  return file;
}

// In one call, so that the records of several processes do not mix.
void record(Head head, std::string_view first = {}, std::string_view second = {}) {
  const int error = errno;
  head.first_bytes = static_cast<std::uint32_t>(first.size());
  head.second_bytes = static_cast<std::uint32_t>(second.size());
  std::array<iovec, 3> parts{{{&head, sizeof head},
                              {const_cast<char*>(first.data()), first.size()},
                              {const_cast<char*>(second.data()), second.size()}}};
  const auto size = static_cast<long>(sizeof head + first.size() + second.size());
  if (syscall(SYS_writev, log_file(), parts.data(), parts.size()) != size) std::_Exit(99);
  errno = error;
}

std::string absolute(const char* path) {
  if (*path == '/') return std::filesystem::path(path).lexically_normal();
  std::array<char, 4096> here{};
  return syscall(SYS_getcwd, here.data(), here.size()) < 0
             ? std::string(path)
             : (std::filesystem::path(here.data()) / path).lexically_normal().string();
}
// The memory that SQLite's processes share is none of the disk.
bool is_recorded(std::string_view path) {
  return !folder().empty() && path.starts_with(folder()) && !path.ends_with("-shm");
}
std::string path_of(int descriptor) {
  std::array<char, 4096> text{};
  const std::string link = "/proc/self/fd/" + std::to_string(descriptor);
  const long size = syscall(SYS_readlinkat, AT_FDCWD, link.c_str(), text.data(), text.size());
  return size < 0 ? std::string() : std::string(text.data(), static_cast<std::size_t>(size));
}
std::uint64_t inode_of(int descriptor) {
  const auto index = static_cast<std::size_t>(descriptor);
  return index < most_descriptors ? inodes[index].load() : 0;
}
void set_inode(int descriptor, std::uint64_t inode) {
  const auto index = static_cast<std::size_t>(descriptor);
  if (index < most_descriptors) inodes[index] = inode;
}

// A descriptor that was opened with these flags.
int note_open(int descriptor, const std::string& path, int flags, bool was_there) {
  if (descriptor < 0) return descriptor;
  set_inode(descriptor, 0);
  struct stat status{};
  if (!is_recorded(path) || fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) {
    return descriptor;
  }
  set_inode(descriptor, status.st_ino);
  if (!was_there) {
    record({.kind = Kind::create, .inode = status.st_ino}, path);
  } else if ((flags & O_TRUNC) != 0) {
    record({.kind = Kind::truncate, .inode = status.st_ino});
  }
  return descriptor;
}
bool is_there(const std::string& path) {
  struct stat status{};
  return lstat(path.c_str(), &status) == 0;
}
int open_and_note(int at, const char* name, int flags, unsigned mode) {
  const std::string path =
      *name == '/' || at == AT_FDCWD ? absolute(name) : path_of(at) + "/" + name;
  const bool was_there = !is_recorded(path) || is_there(path);
  const long descriptor = syscall(SYS_openat, at, name, flags, mode);
  return note_open(static_cast<int>(descriptor), path, flags, was_there);
}

// For the fault rename_first.
thread_local std::uint64_t late_sync = 0;

bool is_database(std::string_view path) { return path.find("queue.db") != std::string_view::npos; }

void record_whole(int descriptor, std::uint64_t inode) {
  std::string text;
  std::array<char, 64 * 1024> buffer{};
  ssize_t count = 0;
  while ((count = pread(descriptor, buffer.data(), buffer.size(),
                        static_cast<off_t>(text.size()))) > 0) {
    text.append(buffer.data(), static_cast<std::size_t>(count));
  }
  record({.kind = Kind::write, .inode = inode}, text);
}

int synchronise(int descriptor) {
  const std::string path = path_of(descriptor);
  struct stat status{};
  if (fstat(descriptor, &status) != 0) return -1;
  if (S_ISDIR(status.st_mode)) {
    if (fault() == "folder_sync_error") {
      errno = EIO;
      return -1;
    }
    if (fault() != "no_folder_sync") record({.kind = Kind::sync_folder}, path);
    return 0;
  }
  const std::uint64_t inode = inode_of(descriptor);
  if (inode == 0) return 0;
  if (fault() == (is_database(path) ? "no_database_sync" : "no_file_sync")) return 0;
  if ((fcntl(descriptor, F_GETFL) & O_ACCMODE) == O_RDONLY) record_whole(descriptor, inode);
  if (fault() == "rename_first" && !is_database(path)) {
    late_sync = inode;
    return 0;
  }
  record({.kind = Kind::sync, .inode = inode});
  return 0;
}

ssize_t note_write(int descriptor, const char* bytes, ssize_t count, off_t offset) {
  if (count > 0) {
    record({.kind = Kind::write,
            .inode = inode_of(descriptor),
            .number = static_cast<std::uint64_t>(offset)},
           {bytes, static_cast<std::size_t>(count)});
  }
  return count;
}

int rename_and_note(const char* from, const char* to, unsigned flags) {
  const long status = syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, flags);
  const std::string target = absolute(to);
  if (status != 0 || !is_recorded(target)) return static_cast<int>(status);
  struct stat now{};
  stat(target.c_str(), &now);
  record(
      {.kind = (flags & RENAME_EXCHANGE) != 0 ? Kind::exchange : Kind::rename, .inode = now.st_ino},
      absolute(from), target);
  if (late_sync != 0) record({.kind = Kind::sync, .inode = late_sync});
  late_sync = 0;
  return 0;
}

int remove_and_note(int at, const char* name, int flags) {
  const std::string path =
      *name == '/' || at == AT_FDCWD ? absolute(name) : path_of(at) + "/" + name;
  const long status = syscall(SYS_unlinkat, at, name, flags);
  if (status == 0 && is_recorded(path)) record({.kind = Kind::remove}, path);
  return static_cast<int>(status);
}

unsigned mode_of(int flags, va_list arguments) {
  return (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(arguments, unsigned) : 0;
}

}  // namespace

extern "C" {

int open(const char* name, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const unsigned mode = mode_of(flags, arguments);
  va_end(arguments);
  return open_and_note(AT_FDCWD, name, flags, mode);
}
int open64(const char* name, int flags, ...) __attribute__((alias("open")));
int openat(int at, const char* name, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const unsigned mode = mode_of(flags, arguments);
  va_end(arguments);
  return open_and_note(at, name, flags, mode);
}
int openat64(int at, const char* name, int flags, ...) __attribute__((alias("openat")));

FILE* fopen64(const char* name, const char* mode) {
  using Open = FILE* (*)(const char*, const char*);
  static const auto real = reinterpret_cast<Open>(dlsym(RTLD_NEXT, "fopen64"));
  const std::string path = absolute(name);
  const bool was_there = !is_recorded(path) || is_there(path);
  FILE* stream = real(name, mode);
  if (stream != nullptr) note_open(fileno(stream), path, *mode == 'w' ? O_TRUNC : 0, was_there);
  return stream;
}
FILE* fopen(const char* name, const char* mode) __attribute__((alias("fopen64")));

ssize_t write(int descriptor, const void* bytes, size_t size) {
  const auto* text = static_cast<const char*>(bytes);
  if (descriptor == STDOUT_FILENO && !folder().empty()) record({.kind = Kind::said}, {text, size});
  const ssize_t count = syscall(SYS_write, descriptor, bytes, size);
  if (inode_of(descriptor) == 0) return count;
  const off_t end = lseek(descriptor, 0, SEEK_CUR);
  return note_write(descriptor, text, count, end - count);
}
ssize_t writev(int descriptor, const iovec* parts, int number) {
  if (inode_of(descriptor) == 0) return syscall(SYS_writev, descriptor, parts, number);
  std::string all;
  for (int i = 0; i < number; ++i) {
    all.append(static_cast<const char*>(parts[i].iov_base), parts[i].iov_len);
  }
  return write(descriptor, all.data(), all.size());
}
ssize_t pwrite64(int descriptor, const void* bytes, size_t size, off_t offset) {
  const ssize_t count = syscall(SYS_pwrite64, descriptor, bytes, size, offset);
  if (inode_of(descriptor) == 0) return count;
  return note_write(descriptor, static_cast<const char*>(bytes), count, offset);
}
ssize_t pwrite(int descriptor, const void* bytes, size_t size, off_t offset)
    __attribute__((alias("pwrite64")));

int ftruncate64(int descriptor, off_t size) noexcept {
  const long status = syscall(SYS_ftruncate, descriptor, size);
  if (status == 0 && inode_of(descriptor) != 0) {
    record({.kind = Kind::truncate,
            .inode = inode_of(descriptor),
            .number = static_cast<std::uint64_t>(size)});
  }
  return static_cast<int>(status);
}
int ftruncate(int descriptor, off_t size) noexcept __attribute__((alias("ftruncate64")));

int fsync(int descriptor) { return synchronise(descriptor); }
int fdatasync(int descriptor) { return synchronise(descriptor); }

int close(int descriptor) {
  set_inode(descriptor, 0);
  return static_cast<int>(syscall(SYS_close, descriptor));
}

int rename(const char* from, const char* to) noexcept { return rename_and_note(from, to, 0); }
int renameat2(int, const char* from, int, const char* to, unsigned flags) noexcept {
  return rename_and_note(from, to, flags);
}
int unlink(const char* name) noexcept { return remove_and_note(AT_FDCWD, name, 0); }
int unlinkat(int at, const char* name, int flags) noexcept {
  return remove_and_note(at, name, flags);
}
int remove(const char* name) noexcept {
  const int status = remove_and_note(AT_FDCWD, name, 0);
  return status != 0 && errno == EISDIR ? remove_and_note(AT_FDCWD, name, AT_REMOVEDIR) : status;
}
int mkdir(const char* name, mode_t mode) noexcept {
  const long status = syscall(SYS_mkdirat, AT_FDCWD, name, mode);
  const std::string path = absolute(name);
  if (status == 0 && is_recorded(path)) record({.kind = Kind::make_folder}, path);
  return static_cast<int>(status);
}

}  // extern "C"
