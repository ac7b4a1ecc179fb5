// SPDX-License-Identifier: Apache-2.0
// `stepfabric serve` as a process of its own, and what a host program does with its port.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/process/process.hpp"

namespace host_programs {

// In real time, on a machine under load.
inline constexpr std::chrono::seconds timeout{120};

class Serve : public testing::Test {
 protected:
  // Each test has a folder, empty at its begin, with all that `serve` leaves, its locks included.
  Serve();
  ~Serve() override;

  // Returns when the port is announced.
  void start(const std::vector<std::string>& options, const char* speed = "max");
  // Ctrl-C; the exit status.
  int stop();
  // As the kernel does it for want of memory.
  void kill_at_once();

  std::string file_path(const char* name) const { return folder_ / name; }
  std::string file(const char* name) const;
  std::vector<std::filesystem::path> locks() const;

  int open_port() const;
  // All that is read until `wanted` comes, or nothing within the time.
  static std::string read_until(int descriptor, const std::string& wanted,
                                std::chrono::seconds time = timeout);
  // As hosts do: what is said while the chip starts is lost, so they ask again.
  static bool connect(int descriptor);
  static void write_text(int descriptor, const std::string& text);

  std::filesystem::path port;

 private:
  std::filesystem::path folder_;
  std::optional<process::Process> job_;
};

}  // namespace host_programs
