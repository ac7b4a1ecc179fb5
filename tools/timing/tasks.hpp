// SPDX-License-Identifier: Apache-2.0
// The tasks of a pass of the firmware's main loop: their bounds and the longest times measured.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "tools/timing/calls.hpp"
#include "tools/timing/cost_sum.hpp"
#include "tools/timing/schedule.hpp"

namespace timing {

struct TaskRow {
  std::string name;
  std::optional<Clocks> bound;
  Clocks budget{};
  Calls::Measured measured;
};

// Has the pass and its tasks measured. Throws std::runtime_error where the image lacks marks.
void watch_tasks(const Program& program, Analysis& analysis, Calls& calls);

// The pass first, then its tasks in their order; nothing is measured yet.
std::vector<TaskRow> task_rows(const Program& program, Analysis& analysis);
void add_measured(std::vector<TaskRow>& rows, const Calls& calls);

// What schedule.hpp needs of the image, but for the refill without a line.
Load load_of(const Program& program, Analysis& analysis, const std::vector<TaskRow>& rows);
// The refill where no line begins: to bind it the image's facts are changed. Adds why it has none.
std::optional<Clocks> refill_without_line(const Program& program, const Costs& costs, bool has_zbb,
                                          std::set<Problem>& problems);

// At so many clocks per second.
std::string to_text(const std::vector<TaskRow>& rows, std::uint32_t clock_hz);
std::string to_json(const std::vector<TaskRow>& rows);
// With what the instructions of the run cost.
std::string to_json(const std::vector<TaskRow>& rows, const CostSum& sum);

}  // namespace timing
