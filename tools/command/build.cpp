// SPDX-License-Identifier: Apache-2.0
// Calls of cmake, one at a time per build folder.
#include "tools/command/build.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <fstream>
#include <stdexcept>
#include <thread>

#include "tools/command/signals.hpp"

namespace command {

namespace {

constexpr std::chrono::milliseconds look_interval{20};

// The lock that tools/command/build_and_run.sh takes too.
class BuildLock {
 public:
  BuildLock() : file_(open((build_folder() / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644)) {
    if (file_ >= 0) {
      flock(file_, LOCK_EX);
    }
  }
  BuildLock(const BuildLock&) = delete;
  BuildLock& operator=(const BuildLock&) = delete;
  ~BuildLock() {
    if (file_ >= 0) {
      close(file_);
    }
  }

 private:
  int file_;
};

std::string last_lines(const std::filesystem::path& file, std::size_t count) {
  std::ifstream stream(file);
  std::deque<std::string> lines;
  for (std::string line; std::getline(stream, line);) {
    lines.push_back(line);
    if (lines.size() > count) {
      lines.pop_front();
    }
  }
  return fmt::format("{}", fmt::join(lines, "\n"));
}

// What execvp() wants.
std::vector<char*> pointers_to(const std::vector<std::string>& arguments) {
  std::vector<char*> pointers;
  for (const std::string& argument : arguments) {
    pointers.push_back(const_cast<char*>(argument.c_str()));
  }
  pointers.push_back(nullptr);
  return pointers;
}

// `log` empty: the program writes to this one's terminal. It heads a process group: what it has
// started ends with it on a signal to this process.
int run_with_output(const std::vector<std::string>& arguments, const std::filesystem::path& log) {
  const std::vector<char*> pointers = pointers_to(arguments);
  const pid_t child = fork();
  if (child < 0) {
    throw std::runtime_error("cannot start " + arguments.front());
  }
  if (child == 0) {
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    signal(SIGPIPE, SIG_DFL);
    if (!log.empty()) {
      const int file = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
      dup2(file, STDOUT_FILENO);
      dup2(file, STDERR_FILENO);
    }
    execvp(pointers.front(), pointers.data());
    _exit(127);
  }
  setpgid(child, child);  // whichever process comes first
  int status = 0;
  bool passed_on = false;
  while (waitpid(child, &status, WNOHANG) == 0) {
    if (interrupt_requested() && !passed_on) {
      kill(-child, SIGTERM);
      passed_on = true;
    }
    std::this_thread::sleep_for(look_interval);
  }
  end_if_interrupted();
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

std::filesystem::path project_folder() { return STEPFABRIC_PROJECT_FOLDER; }

std::filesystem::path build_folder() {
  const char* folder = std::getenv("STEPFABRIC_BUILD_DIR");
  return folder != nullptr && *folder != '\0' ? folder : STEPFABRIC_BUILD_FOLDER;
}

void build(const std::vector<std::string>& targets) {
  const BuildLock lock;
  const std::filesystem::path log = build_folder() / "build.log";
  std::vector<std::string> arguments{"cmake", "--build", build_folder().string(), "--target"};
  arguments.insert(arguments.end(), targets.begin(), targets.end());
  if (run_with_output(arguments, log) != 0) {
    throw std::runtime_error(fmt::format("{}\nthe build of {} failed; the whole log is in {}",
                                         last_lines(log, 40), fmt::join(targets, ", "),
                                         log.string()));
  }
}

int run_program(const std::vector<std::string>& arguments) {
  return run_with_output(arguments, {});
}

void become_program(const std::vector<std::string>& arguments) {
  std::fflush(nullptr);
  execvp(arguments.front().c_str(), pointers_to(arguments).data());
  throw std::runtime_error("cannot start " + arguments.front());
}

}  // namespace command
