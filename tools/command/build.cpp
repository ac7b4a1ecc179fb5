// SPDX-License-Identifier: Apache-2.0
// Calls of cmake, one at a time per build folder.
#include "tools/command/build.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cstdlib>
#include <deque>
#include <fstream>
#include <stdexcept>

#include "tools/command/signals.hpp"
#include "tools/process/process.hpp"

namespace command {

namespace {

// The lock that tools/command/build_and_run.sh takes too.
class BuildLock {
 public:
  BuildLock() : file_(open((build_folder() / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644)) {
    if (file_ >= 0) flock(file_, LOCK_EX);
  }
  BuildLock(const BuildLock&) = delete;
  BuildLock& operator=(const BuildLock&) = delete;
  ~BuildLock() {
    if (file_ >= 0) close(file_);
  }

 private:
  int file_;
};

std::string last_lines(const std::filesystem::path& file, std::size_t count) {
  std::ifstream stream(file);
  std::deque<std::string> lines;
  for (std::string line; std::getline(stream, line);) {
    lines.push_back(line);
    if (lines.size() > count) lines.pop_front();
  }
  return fmt::format("{}", fmt::join(lines, "\n"));
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
  const process::Start start{.arguments = arguments, .output = log};
  if (process::run(start, {}, end_if_interrupted).exit_status != 0) {
    throw std::runtime_error(fmt::format("{}\nthe build of {} failed; the whole log is in {}",
                                         last_lines(log, 40), fmt::join(targets, ", "),
                                         log.string()));
  }
}

int run_program(const std::vector<std::string>& arguments) {
  return process::run({.arguments = arguments}, {}, end_if_interrupted).exit_status;
}

}  // namespace command
