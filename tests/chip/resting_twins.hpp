// SPDX-License-Identifier: Apache-2.0
// Two models of the chip, of which the first evaluates all clock edges, the second
// those that matter.
#pragma once

#include "sim/simulation/verilated_chip.hpp"
#include "tests/chip/twins.hpp"

namespace tests {

class RestingTwins : public Twins {
 public:
  explicit RestingTwins(std::uint32_t clock_hz);

  void write_memory(std::uint32_t address, std::uint32_t word) override;

  // What no pin shows: throws TwinsDiffer where memories or counters are not the same.
  void compare_inside() const;

 private:
  sim::VerilatedChip all_edges_;
  sim::VerilatedChip needed_edges_;
};

}  // namespace tests
