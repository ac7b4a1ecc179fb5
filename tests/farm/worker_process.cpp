// SPDX-License-Identifier: Apache-2.0
// A thread reads all the time, so that the worker never waits.
#include "tests/farm/worker_process.hpp"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>

#include "directories.hpp"

namespace farm_test {

WorkerProcess::WorkerProcess(const std::filesystem::path& folder, const std::string& address,
                             const std::string& name, unsigned seed,
                             std::chrono::milliseconds lease_time)
    : process_({.arguments = {BUILD_DIRECTORY "/bin/farm_worker",
                              (std::filesystem::create_directories(folder), folder.string()),
                              address, name, std::to_string(seed % 1'000'000),
                              std::to_string(lease_time.count())},
                .to_pipe = true,
                .has_input = false}),
      reader_([this] {
        std::array<char, 4096> buffer{};
        ssize_t count = 0;
        while ((count = read(process_.pipe(), buffer.data(), buffer.size())) > 0) {
          const std::scoped_lock lock(mutex_);
          said_.append(buffer.data(), static_cast<std::size_t>(count));
        }
      }) {}

WorkerProcess::~WorkerProcess() { kill(); }

std::string WorkerProcess::said() {
  const std::scoped_lock lock(mutex_);
  return said_;
}

std::size_t WorkerProcess::lines() {
  return static_cast<std::size_t>(std::ranges::count(said(), '\n'));
}

std::string WorkerProcess::kill() {
  if (!process_.ending()) {
    process_.signal(SIGKILL);
    process_.wait();
  }
  if (reader_.joinable()) reader_.join();
  return said_;
}

}  // namespace farm_test
