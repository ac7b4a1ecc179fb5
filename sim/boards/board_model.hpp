// SPDX-License-Identifier: Apache-2.0
// The chip on a board: what is outside sees the board's pins only.
#pragma once

#include <verilated.h>

#include <memory>

#include "sim/simulation/chip_model.hpp"
#include "Vboard.h"

namespace sim {

// The levels that are low where a thing is on are turned here as the wiring does it: a driver is
// enabled where its pin is low. Times are clocks since the end of the board's own reset.
class BoardModel : public ChipModel {
 public:
  explicit BoardModel(std::uint32_t clock_hz);
  ~BoardModel() override;

  void permit_software_stepping() override;
  void set_memory_bytes(std::uint32_t bytes) override;
  void count_into(EvaluationCounts&) override {}
  void advance(Clock limit) override;
  void reset() override;
  std::uint32_t read_memory(std::uint32_t address) const override;
  void write_memory(std::uint32_t address, std::uint32_t word) override;
  QueueStatistics queue_statistics() const override;
  ProcessorStatistics processor_statistics() const override { return processor_; }
  void trace_to(const std::string& file) override;

 private:
  void start();
  void clock();
  void set_inputs();
  OutputPins sampled_outputs() const;

  std::unique_ptr<VerilatedContext> context_;
  std::unique_ptr<Vboard> model_;
  ProcessorStatistics processor_;
  unsigned watch_phase_ = 0;  // clocks since the second oscillator's last change
  bool started_ = false;
};

}  // namespace sim
