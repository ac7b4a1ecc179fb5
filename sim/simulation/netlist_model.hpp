// SPDX-License-Identifier: Apache-2.0
// All of the chip by its netlist.
#pragma once

#include <verilated.h>

#include <memory>
#include <stdexcept>

#include "sim/simulation/chip_model.hpp"
#include "sim/simulation/model_clocks.hpp"
#include "sim/simulation/model_pins.hpp"
#include "sim/simulation/trace.hpp"
#include "Vprinter_core.h"
#include "Vprinter_core___024root.h"

STEPFABRIC_MODEL_FUNCTIONS(Vprinter_core)

namespace sim {

class NetlistModel : public ChipModel {
 public:
  NetlistModel(std::uint32_t clock_hz, Edges edges);
  ~NetlistModel() override;

  void permit_software_stepping() override { model_->software_stepping = 1; }
  void set_memory_bytes(std::uint32_t) override {
    throw std::runtime_error("the netlist has no more memory than the chip");
  }
  void count_into(EvaluationCounts& counts) override { clocks_->count_into(counts); }
  void advance(Clock limit) override;
  void reset() override;
  std::uint32_t read_memory(std::uint32_t address) const override;
  void write_memory(std::uint32_t address, std::uint32_t word) override;
  QueueStatistics queue_statistics() const override {
    return sampled_queue_statistics(std::as_const(*model_->rootp));
  }
  ProcessorStatistics processor_statistics() const override { return processor_; }
  void trace_to(const std::string& file) override { trace_ = make_trace(*model_, file); }

 protected:
  using Model = Vprinter_core;

  void hold_reset();
  void set_inputs();
  OutputPins sampled_outputs() const { return sampled_output_pins(std::as_const(*model_)); }

  std::unique_ptr<VerilatedContext> context_;
  std::unique_ptr<Vprinter_core> model_;
  std::unique_ptr<ModelClocks<Vprinter_core>> clocks_;
  std::unique_ptr<Trace> trace_;
  ProcessorStatistics processor_;
  InputPins set_inputs_;  // those that the model has
  bool started_ = false;
};

}  // namespace sim
