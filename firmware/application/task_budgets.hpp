// SPDX-License-Identifier: Apache-2.0
// The budgets of the table of tasks, without its texts.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "application/task_table.hpp"

namespace application {

// Clocks, by task.
inline constexpr auto task_budgets = [] {
  std::array<std::uint32_t, units::task_count> budgets{};
  std::ranges::transform(task_table, budgets.begin(), &TaskRow::budget);
  return budgets;
}();

}  // namespace application
