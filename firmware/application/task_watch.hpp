// SPDX-License-Identifier: Apache-2.0
// Measures how long each task of the main loop takes, with the clocks of the hardware's timer, and
// counts where that is more than its budget.
#pragma once

#include <array>
#include <cstdint>

#include "application/statistics.hpp"
#include "drivers/timer.hpp"
#include "units/task_span.hpp"

namespace application {

class TaskWatch {
 public:
  // Writes into `times`, by task.
  TaskWatch(const drivers::Timer& timer, std::array<TaskTimes, units::task_count>& times)
      : timer_(timer), times_(times) {}

  void begin_pass(units::Cycles now) { last_ = static_cast<std::uint32_t>(now.count()); }
  // What has passed since the end of the task before, or the beginning of the pass, was its time.
  [[gnu::noinline]] void end(units::Task task);
  // The time of that end or beginning: its lower half.
  std::uint32_t last() const { return last_; }

 private:
  const drivers::Timer& timer_;
  std::array<TaskTimes, units::task_count>& times_;
  std::uint32_t last_{};  // the time's lower half: no task takes as long as that
};

}  // namespace application
