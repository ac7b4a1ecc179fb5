// SPDX-License-Identifier: Apache-2.0
// How long a task of the firmware's main loop took, as the firmware itself has measured it.
#pragma once

#include <cstdint>
#include <string>

namespace report {

struct TaskResult {
  std::string name;
  std::uint64_t longest_clocks{};
  std::uint64_t overruns{};  // of its budget (firmware/application/task_table.hpp)
};

}  // namespace report
