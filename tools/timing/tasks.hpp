// SPDX-License-Identifier: Apache-2.0
// The tasks of a pass of the firmware's main loop: their bounds beside their longest times measured.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/timing/calls.hpp"

namespace timing {

struct TaskRow {
  std::string name;  // of the function
  std::string does;
  std::optional<Clocks> bound;
  Calls::Measured measured;
};

// The pass first, then its tasks in their order. Throws std::runtime_error where the image lacks one.
std::vector<TaskRow> task_rows(const Program& program, Analysis& analysis, const Calls& calls);

// At so many clocks per second.
std::string to_text(const std::vector<TaskRow>& rows, std::uint32_t clock_hz);
std::string to_json(const std::vector<TaskRow>& rows);

}  // namespace timing
