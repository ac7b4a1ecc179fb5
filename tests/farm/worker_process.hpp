// SPDX-License-Identifier: Apache-2.0
// A farm_worker in a process of its own, and what it has said.
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <mutex>
#include <string>
#include <thread>

#include "tools/process/process.hpp"

namespace farm_test {

class WorkerProcess {
 public:
  // The folder is made where it is missing.
  WorkerProcess(const std::filesystem::path& folder, const std::string& address,
                const std::string& name, unsigned seed, std::chrono::milliseconds lease_time);
  ~WorkerProcess();
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;

  void signal(int number) const { process_.signal(number); }
  std::string said();
  std::size_t lines();
  // SIGKILL. All that it has said; an incomplete last line was not said.
  std::string kill();

 private:
  process::Process process_;
  std::mutex mutex_;
  std::string said_;
  std::thread reader_;
};

}  // namespace farm_test
