// SPDX-License-Identifier: Apache-2.0
// A search for inputs of the host that make the tasks of the firmware's main loop take long.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/timing/tasks.hpp"

namespace command {

struct WorstInputs {
  std::uint64_t inputs{};
  std::vector<timing::TaskRow> rows;  // the tasks, then the pass; measured by the firmware itself
  struct Input {
    std::string_view start;  // what the printer was doing
    std::string input;  // readable
  };
  std::vector<Input> worst;  // by task
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

struct WorstInputSearch {
  std::uint64_t inputs{};  // in all
  std::uint64_t seed = 1;
  // Where its state is kept, now and then and at the end; empty: nowhere. Where there is one, the
  // search goes on.
  std::filesystem::path state{};
};

// Co-simulates so many inputs, or fewer where one takes longer than a bound or the user interrupts
// it. The same seed finds the same. Shows its progress. Throws std::runtime_error where the state
// is that of another firmware, program or seed, and where a pass has no end.
WorstInputs search_worst_inputs(const timing::Program& program, const timing::Costs& costs,
                                const WorstInputSearch& search);

std::string to_text(const WorstInputs& found);
std::string to_json(const WorstInputs& found);

}  // namespace command
