// SPDX-License-Identifier: Apache-2.0
// The tasks of a pass of the firmware's main loop: their bounds and the longest times measured.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/timing/calls.hpp"

namespace timing {

struct TaskRow {
  std::string name;
  std::optional<Clocks> bound;
  Calls::Measured measured;
};

// Has the pass and its tasks measured. Throws std::runtime_error where the image lacks marks.
void watch_tasks(const Program& program, Analysis& analysis, Calls& calls);

// The pass first, then its tasks in their order (firmware/units/task_span.hpp).
std::vector<TaskRow> task_rows(const Program& program, Analysis& analysis, const Calls& calls);

// At so many clocks per second.
std::string to_text(const std::vector<TaskRow>& rows, std::uint32_t clock_hz);
std::string to_json(const std::vector<TaskRow>& rows);

}  // namespace timing
