// SPDX-License-Identifier: Apache-2.0
// Running a program to its end or to a time limit, with what it says in files.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace proof {

struct ProcessResult {
  int exit_status{};  // 128 + signal where it was killed
  bool timed_out{};
};

// The program and all that it starts are killed at the limit, and where this program is
// interrupted.
ProcessResult run_process(const std::vector<std::string>& arguments,
                          const std::filesystem::path& folder, const std::filesystem::path& log,
                          std::chrono::seconds limit);

// The text of a file; empty where it does not exist.
std::string text_of(const std::filesystem::path& file);

}  // namespace proof
