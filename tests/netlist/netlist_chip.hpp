// SPDX-License-Identifier: Apache-2.0
// A board's netlist of its FPGA's cells, the firmware in their initial values, as a chip of
// the co-simulation.
#pragma once

#include <memory>

#include "sim/simulation/chip.hpp"

class VerilatedContext;

namespace tests {

// The model, of the board in whose header it is (names).
class BoardNetlist;

// Its time begins where the board's reset ends, as VerilatedChip's does: the board's own clocks of
// reset after configuration are over. The memory can neither be written nor read: what is in it has
// come with the netlist.
class NetlistChip : public sim::Chip {
 public:
  NetlistChip();
  ~NetlistChip() override;

  void advance(sim::Clock limit) override;
  // Throws std::logic_error: the board has no reset but its configuration.
  void reset() override;
  std::uint32_t read_memory(std::uint32_t address) const override;
  void write_memory(std::uint32_t address, std::uint32_t word) override;
  // Unknown, since the netlist keeps no names: all zero.
  sim::QueueStatistics queue_statistics() const override { return {}; }
  // Of sleeping the board has a lamp; instructions are not counted.
  sim::ProcessorStatistics processor_statistics() const override { return processor_; }
  void trace_to(const std::string& file) override;

 private:
  void clock();
  void set_inputs();
  sim::OutputPins sampled_outputs() const;

  std::unique_ptr<VerilatedContext> context_;
  std::unique_ptr<BoardNetlist> model_;
  sim::ProcessorStatistics processor_;
  unsigned watch_phase_ = 0;
};

}  // namespace tests
