// SPDX-License-Identifier: Apache-2.0
// Where a task of the main loop begins and ends: for tools/timing, which bounds and measures it.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace units {

// In the order of a pass.
enum class Task : std::uint32_t {
  motion,
  serial_line,
  faults,
  heat,
  planning,
  reports,
  commands,
  refill,
  rest
};
inline constexpr std::uint32_t task_count = 9;
inline constexpr std::array<std::string_view, task_count> task_names{
    "motion", "serial line", "faults", "heat", "planning", "reports", "commands", "refill", "rest"};

// From here to the end of the object. No instruction, only entries in a section that is not loaded.
template <Task task>
class TaskSpan {
 public:
  [[gnu::always_inline]] inline TaskSpan() { mark<0>(); }
  [[gnu::always_inline]] inline ~TaskSpan() { mark<1>(); }
  TaskSpan(const TaskSpan&) = delete;
  TaskSpan& operator=(const TaskSpan&) = delete;

 private:
  template <std::uint32_t is_end>
  [[gnu::always_inline]] static inline void mark() {
#ifdef __riscv
    asm inline volatile(
        ".pushsection .task_spans,\"\",@progbits\n"
        ".word 1f, %0, %1\n"
        ".popsection\n"
        "1:" ::"i"(task),
        "i"(is_end));
#endif
  }
};

}  // namespace units
