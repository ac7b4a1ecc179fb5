// SPDX-License-Identifier: Apache-2.0
// What a processor shows while it executes a program.
#pragma once

#include <cstdint>

#include "sim/simulation/chip.hpp"
#include "tools/timing/program.hpp"

namespace timing {

// After a clock.
struct Sample {
  std::uint64_t instructions{};  // that it has executed
  std::uint64_t slept{};
  // Of the next instruction: its address, the clock in which it begins, whether it is an access of
  // the bus.
  Address program_counter{};
  std::uint64_t begins{};
  bool accesses{};
};

inline Sample sample_of(const sim::ProcessorStatistics& statistics) {
  return {.instructions = statistics.instructions,
          .slept = statistics.sleeping_clocks,
          .program_counter = statistics.program_counter,
          .begins = statistics.begins,
          .accesses = statistics.accesses};
}

}  // namespace timing
