// SPDX-License-Identifier: Apache-2.0
// A search for inputs of the host that make the tasks of the firmware's main loop take long.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tools/timing/tasks.hpp"

namespace command {

struct WorstInputs {
  std::uint64_t inputs{};
  std::vector<timing::TaskRow> rows;  // the tasks, then the pass; measured by the firmware itself
  std::vector<std::string> worst;  // by task, readable
  struct Function {
    std::string name;
    std::optional<timing::Clocks> bound;
    timing::Clocks longest{};
  };
  // Parser and planner by themselves, in the first inputs and in the worst ones.
  std::vector<Function> functions;
  // The firmware's measurement of a task begins where the one before has ended: it may be so much
  // longer than the task's bound.
  timing::Clocks between_tasks{};
};

// Whether nothing took longer than its bound, and all has one.
bool holds(const WorstInputs& found);

// Co-simulates so many inputs, each with the same printer. The same seed finds the same.
WorstInputs search_worst_inputs(const timing::Program& program, const timing::Costs& costs,
                                std::uint64_t inputs, std::uint64_t seed);

std::string to_text(const WorstInputs& found);
std::string to_json(const WorstInputs& found);

}  // namespace command
