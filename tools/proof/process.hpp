// SPDX-License-Identifier: Apache-2.0
// Running a program to its end or to a time limit, with what it says in files.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "tools/files/file_text.hpp"

namespace proof {

using files::text_of;

struct ProcessResult {
  int exit_status{};  // 128 + signal where it was killed
  bool timed_out{};
  double cpu_seconds{};  // of the program and the children that it waited for
};

// The program and all that it starts are killed at the limit, and where this program is
// interrupted. Each process is also killed, with `timed_out`, when it has used so much processor
// time (0: any), which does not depend on what else the machine does.
ProcessResult run_process(const std::vector<std::string>& arguments,
                          const std::filesystem::path& folder, const std::filesystem::path& log,
                          std::chrono::seconds limit,
                          std::chrono::seconds cpu_limit = std::chrono::seconds{0});

}  // namespace proof
