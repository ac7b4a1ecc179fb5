// SPDX-License-Identifier: Apache-2.0
// The chip by one of its models.
#include "sim/simulation/verilated_chip.hpp"

#include <fmt/format.h>
#include <verilated.h>

#include "sim/replay/interval_recorder.hpp"
#include "sim/simulation/chip_model.hpp"

// The model calls this where an assertion fails; it was made with VL_USER_STOP and VL_USER_FATAL.
void vl_stop(const char* file, int line, const char*) VL_MT_UNSAFE {
  throw sim::HardwareAssertion(fmt::format(
      "an assertion of the hardware failed, see its label above (netlist {}:{})", file, line));
}

void vl_fatal(const char* file, int line, const char*, const char* message) VL_MT_UNSAFE {
  throw sim::HardwareAssertion(
      fmt::format("the model of the chip failed: {} ({}:{})", message, file, line));
}

namespace sim {

namespace {

std::unique_ptr<ChipModel> made_model(std::uint32_t clock_hz, Edges edges, Processor processor) {
  if (processor == Processor::model) {
    if (auto model = make_joined_model(clock_hz, edges)) return model;
  }
  return make_netlist_model(clock_hz, edges);
}

}  // namespace

VerilatedChip::VerilatedChip(std::uint32_t clock_hz, Edges edges)
    : VerilatedChip(clock_hz, edges,
                    edges == Edges::leaping ? Processor::model : Processor::netlist) {}

VerilatedChip::VerilatedChip(std::uint32_t clock_hz, Edges edges, Processor processor)
    : model_(made_model(clock_hz, edges, processor)) {
  outputs_ = model_->outputs();
}

VerilatedChip::~VerilatedChip() = default;

void VerilatedChip::permit_software_stepping() { model_->permit_software_stepping(); }

void VerilatedChip::set_memory_bytes(std::uint32_t bytes) { model_->set_memory_bytes(bytes); }

void VerilatedChip::count_into(EvaluationCounts& counts) { model_->count_into(counts); }

void VerilatedChip::record(replay::IntervalRecorder& recorder) {
  if (!model_->takes_snapshots()) {
    throw std::runtime_error("only a chip with the model of its processor can be recorded");
  }
  recorder_ = &recorder;
}

void VerilatedChip::advance(Clock limit) {
  model_->inputs() = inputs_;
  if (recorder_ != nullptr) {
    if (recorder_->wants_snapshot(now_)) {
      if (auto snapshot = model_->snapshot()) recorder_->put_snapshot(*std::move(snapshot));
    }
    recorder_->put_inputs(now_, inputs_);
  }
  model_->advance(limit);
  now_ = model_->now();
  outputs_ = model_->outputs();
  if (recorder_ != nullptr) recorder_->put_outputs(now_, outputs_);
}

void VerilatedChip::reset() {
  if (recorder_ != nullptr) recorder_->discard();
  model_->inputs() = inputs_;
  model_->reset();
  outputs_ = model_->outputs();
}

std::uint32_t VerilatedChip::read_memory(std::uint32_t address) const {
  return model_->read_memory(address);
}

void VerilatedChip::write_memory(std::uint32_t address, std::uint32_t word) {
  if (recorder_ != nullptr) recorder_->discard();
  model_->write_memory(address, word);
}

QueueStatistics VerilatedChip::queue_statistics() const { return model_->queue_statistics(); }

ProcessorStatistics VerilatedChip::processor_statistics() const {
  return model_->processor_statistics();
}

void VerilatedChip::trace_to(const std::string& file) { model_->trace_to(file); }

}  // namespace sim
