// SPDX-License-Identifier: Apache-2.0
// A cyclic executive that is run pass by pass, with chosen times, and what its events come to.
#pragma once

#include <optional>
#include <random>
#include <vector>

#include "tools/timing/schedule.hpp"

namespace timing {

// Times in clocks from the beginning of the pass.
struct Pass {
  std::array<Clocks, units::task_count> looks{};  // when each task looks, and is done
  Clocks refill_begins{};
  std::vector<Clocks> lines{};  // of refill, handed over by then
  Clocks length{};
  Clocks sleep{};  // after it, where nothing wakes the loop
};

// Passes within the bounds; the last one is repeated.
using Passes = std::vector<Pass>;

// The longest of the requirement in this run, in the unit of its response; nothing where the run
// cannot show it (the speed of bits).
std::optional<std::uint64_t> longest_in(Requirement requirement, const Facts& facts,
                                        const Load& load, Rate rate, const Passes& run);

// Random times, and of each bound often all or nothing.
Passes random_run(const Facts& facts, const Load& load, Rate rate, std::mt19937& random);
// A pass whose tasks look at once, then passes whose tasks look as late as they can; all as long as
// can be.
Passes worst_run(const Facts& facts, const Load& load, Rate rate);

}  // namespace timing
