// SPDX-License-Identifier: Apache-2.0
// The longest times of the tasks of the firmware's main loop, in a co-simulated print.
#pragma once

#include <filesystem>

#include "tools/timing/cost_sum.hpp"
#include "tools/timing/tasks.hpp"

namespace command {

inline constexpr std::uint32_t tasks_clock_hz = 4'000'000;

struct TaskTimes {
  std::vector<timing::TaskRow> rows;
  timing::CostSum sum;
};

// The first `seconds` of a print, from warm heaters on. Throws std::runtime_error where the file
// cannot be read, or where the processor does what the analysis does not know.
TaskTimes task_times(const timing::Program& program, const timing::Costs& costs,
                     const std::filesystem::path& file, double seconds);

}  // namespace command
