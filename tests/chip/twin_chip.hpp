// SPDX-License-Identifier: Apache-2.0
// Two models of the chip side by side, of which one evaluates all clock edges: they must do the
// same.
#pragma once

#include <stdexcept>

#include "sim/simulation/verilated_chip.hpp"

namespace tests {

// The models have parted: what() says where.
class TwinsDiffer : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// To the simulation one chip. Throws TwinsDiffer at the clock in which the pins differ.
class TwinChip : public sim::Chip {
 public:
  explicit TwinChip(std::uint32_t clock_hz);

  void advance(sim::Clock limit) override;
  void reset() override;
  std::uint32_t read_memory(std::uint32_t address) const override;
  void write_memory(std::uint32_t address, std::uint32_t word) override;
  sim::QueueStatistics queue_statistics() const override { return tested_.queue_statistics(); }
  sim::ProcessorStatistics processor_statistics() const override {
    return tested_.processor_statistics();
  }
  void trace_to(const std::string& file) override { tested_.trace_to(file); }

  // What no pin shows: throws TwinsDiffer where memories or counters are not the same.
  void compare_inside() const;

 private:
  void take_over();

  sim::VerilatedChip reference_;
  sim::VerilatedChip tested_;
};

}  // namespace tests
