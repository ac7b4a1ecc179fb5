// SPDX-License-Identifier: Apache-2.0
// The chip as Verilated model, with its processor by the netlist or by a model of its own.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include "sim/simulation/chip.hpp"
#include "sim/simulation/edges.hpp"
#include "sim/simulation/evaluation_counts.hpp"

namespace replay {
class IntervalRecorder;
}

namespace sim {

class ChipModel;

// An assertion of the hardware has failed; the model printed its label.
class HardwareAssertion : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// The chip is in reset until the first advance(), and until the next one after reset(). Clocks in
// reset do not count.
class VerilatedChip : public Chip {
 public:
  // The processor by its model where edges are leapt over, else by the netlist.
  explicit VerilatedChip(std::uint32_t clock_hz, Edges edges = Edges::leaping);
  VerilatedChip(std::uint32_t clock_hz, Edges edges, Processor processor);
  ~VerilatedChip() override;

  // Lets the firmware drive the step and direction pins itself, which no board does. The model of
  // the processor also gets the memory of the comparison, all 0, which is larger than the chip's;
  // the netlist has the chip's. Before a program is loaded.
  void permit_software_stepping();
  // Of a chip with more than the default; before anything is loaded. Throws where the processor is
  // a netlist.
  void set_memory_bytes(std::uint32_t bytes);

  // Clocks are counted there from now on; the counts must outlive the last advance().
  void count_into(EvaluationCounts& counts);

  // Records all pins and some snapshots from now on. The recorder must outlive the last advance().
  // Throws std::runtime_error where the processor is not a model of its own.
  void record(replay::IntervalRecorder& recorder);

  void advance(Clock limit) override;
  void reset() override;
  std::uint32_t read_memory(std::uint32_t address) const override;
  void write_memory(std::uint32_t address, std::uint32_t word) override;
  QueueStatistics queue_statistics() const override;
  ProcessorStatistics processor_statistics() const override;
  void trace_to(const std::string& file) override;

 private:
  std::unique_ptr<ChipModel> model_;
  replay::IntervalRecorder* recorder_ = nullptr;
};

}  // namespace sim
