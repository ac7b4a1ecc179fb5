// SPDX-License-Identifier: Apache-2.0
// Rounds of the main loop: how long they take while motion needs lines.
#pragma once

#include <array>

#include "tools/timing/schedule.hpp"

namespace timing {

inline constexpr std::array<units::Task, units::task_count> all_tasks = [] {
  std::array<units::Task, units::task_count> tasks{};
  for (std::size_t i = 0; i < tasks.size(); ++i) tasks[i] = static_cast<units::Task>(i);
  return tasks;
}();

// All of these only of a load that is whole.
Clocks bound_of(const Load& load, units::Task task);
// From the end of a task to the beginning of the next, or of a pass to its first.
Clocks longest_gap(const Load& load);
// Of a pass that only refills, without the refill: motion, the rest, and the gaps.
Clocks overhead(const Load& load);
// Put off while motion needs lines.
bool may_wait(units::Task task, const Facts& facts);
// Waits of tasks in so many rounds at most, each of some passes.
std::uint64_t waits_in(std::uint64_t rounds, const Facts& facts, const Load& load);
// Passes in them at most that end because a task must wait.
std::uint64_t put_off_in(std::uint64_t rounds, const Facts& facts, const Load& load);
Clocks time_of_rounds(std::uint64_t rounds, const Facts& facts, const Load& load);

}  // namespace timing
