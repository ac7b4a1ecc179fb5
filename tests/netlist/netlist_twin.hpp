// SPDX-License-Identifier: Apache-2.0
// The netlist of the board beside the model of the chip that it was made of: their pins must be
// equal in every clock.
#pragma once

#include <stdexcept>

#include "sim/simulation/verilated_chip.hpp"
#include "tests/netlist/netlist_chip.hpp"

namespace tests {

// The pins have parted: what() says when and which.
class PinsDiffer : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// To the simulation one chip. The program is written into the model's memory only; the netlist has
// its own.
class NetlistTwin : public sim::Chip {
 public:
  explicit NetlistTwin(std::uint32_t clock_hz);

  // Throws PinsDiffer.
  void advance(sim::Clock limit) override;
  void reset() override;
  std::uint32_t read_memory(std::uint32_t address) const override;
  void write_memory(std::uint32_t address, std::uint32_t word) override;
  sim::QueueStatistics queue_statistics() const override { return model_.queue_statistics(); }
  sim::ProcessorStatistics processor_statistics() const override {
    return model_.processor_statistics();
  }
  void trace_to(const std::string& file) override { model_.trace_to(file); }

  // The lamp tells it in every clock.
  std::uint64_t netlist_sleeping_clocks() const {
    return netlist_.processor_statistics().sleeping_clocks;
  }

 private:
  void compare();

  sim::VerilatedChip model_;
  NetlistChip netlist_;
};

}  // namespace tests
