// SPDX-License-Identifier: Apache-2.0
#include "application/task_watch.hpp"

#include <algorithm>

#include "application/task_budgets.hpp"

namespace application {

void TaskWatch::end(units::Task task) {
  const std::uint32_t now = timer_.now_low();
  const std::uint32_t slice = now - last_;
  last_ = now;
  const auto index = static_cast<std::size_t>(task);
  TaskTimes& times = times_[index];
  times.longest_clocks = std::max(times.longest_clocks, slice);
  if (slice > task_budgets[index]) ++times.overruns;
}

}  // namespace application
