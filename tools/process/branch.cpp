// SPDX-License-Identifier: Apache-2.0
#include "tools/process/branch.hpp"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <exception>
#include <stdexcept>
#include <string_view>
#include <system_error>

namespace process {

namespace {

// The first byte of what the copy writes.
constexpr char returned = 'r', threw = 't';

void write_all(int pipe, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(pipe, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) {
      return;  // the reader has gone
    }
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

std::string outcome(const std::function<std::string()>& work) {
  try {
    return returned + work();
  } catch (const std::exception& error) {
    return threw + std::string(error.what());
  }
}

}  // namespace

Branch::Branch(const std::function<std::string()>& work) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  const pid_t parent = getpid();
  id_ = fork();
  if (id_ < 0) {
    const int error = errno;
    close(ends[0]);
    close(ends[1]);
    throw std::system_error(error, std::generic_category(), "fork");
  }
  if (id_ == 0) {
    close(ends[0]);
    // Also where this process is killed.
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(0);
    std::signal(SIGINT, SIG_IGN);
    std::signal(SIGPIPE, SIG_IGN);
    write_all(ends[1], outcome(work));
    _exit(0);  // what this process has still to write is not the copy's
  }
  close(ends[1]);
  pipe_ = ends[0];
}

Branch::~Branch() {
  if (id_ == 0) return;
  kill(id_, SIGKILL);
  end();
}

// Its status.
int Branch::end() {
  close(pipe_);
  int status = 0;
  while (waitpid(id_, &status, 0) < 0 && errno == EINTR) {
  }
  id_ = 0;
  return status;
}

std::string Branch::result() {
  std::string bytes;
  std::array<char, 4096> buffer{};
  for (;;) {
    const ssize_t count = read(pipe_, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    bytes.append(buffer.data(), static_cast<std::size_t>(count));
  }
  const int status = end();
  if (bytes.starts_with(returned)) return bytes.substr(1);
  if (bytes.starts_with(threw)) throw std::runtime_error(bytes.substr(1));
  throw std::runtime_error(WIFSIGNALED(status)
                               ? "a process was ended by signal " + std::to_string(WTERMSIG(status))
                               : "a process ended without a result");
}

}  // namespace process
