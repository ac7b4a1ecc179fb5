// SPDX-License-Identifier: Apache-2.0
// Instructions as the processor model executes them, and the costs that the analysis gives them.
#pragma once

#include <cstdint>
#include <vector>

#include "tools/timing/costs.hpp"
#include "tools/timing/program.hpp"

namespace timing {

struct Step {
  Address address{};
  std::uint64_t begins{};  // the clock from which on it could execute
  bool on_bus = false;
};

// From the start of the program until it comes to `stop`, or for so many clocks. Every register of
// the bus reads as `word`.
std::vector<Step> trace(const Program& program, Address stop, std::uint64_t clocks,
                        std::uint32_t word);

// Of all steps but the last.
std::uint64_t sum_of_costs(const Program& program, const Costs& costs,
                           const std::vector<Step>& steps);

}  // namespace timing
