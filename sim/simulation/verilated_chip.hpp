// SPDX-License-Identifier: Apache-2.0
// The chip as Verilated model: with its source file the only place that knows the model's names.
#pragma once

#include <memory>
#include <stdexcept>

#include "sim/simulation/chip.hpp"
#include "sim/simulation/edges.hpp"

class VerilatedContext;
class Vprinter_core;

namespace sim {

class Trace;

// An assertion of the hardware has failed; the model printed its label.
class HardwareAssertion : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// The chip is in reset until the first advance(), and until the next one after reset(). Clocks in
// reset do not count.
class VerilatedChip : public Chip {
 public:
  explicit VerilatedChip(std::uint32_t clock_hz, Edges edges = Edges::leaping);
  ~VerilatedChip() override;

  // Lets the firmware drive the step and direction pins itself, which no board does. Before the
  // first advance().
  void permit_software_stepping();

  void advance(Clock limit) override;
  void reset() override;
  std::uint32_t read_memory(std::uint32_t address) const override;
  void write_memory(std::uint32_t address, std::uint32_t word) override;
  QueueStatistics queue_statistics() const override;
  ProcessorStatistics processor_statistics() const override { return processor_; }
  void trace_to(const std::string& file) override;

 private:
  class Clocks;

  void hold_reset();
  void set_inputs();
  OutputPins sampled_outputs() const;

  std::unique_ptr<VerilatedContext> context_;
  std::unique_ptr<Vprinter_core> model_;
  std::unique_ptr<Clocks> clocks_;
  std::unique_ptr<Trace> trace_;
  ProcessorStatistics processor_;
  InputPins set_inputs_;  // those that the model has
  bool started_ = false;
};

}  // namespace sim
