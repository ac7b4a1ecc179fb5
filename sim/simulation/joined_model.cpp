// SPDX-License-Identifier: Apache-2.0
// The processor's model and the netlist of all else, joined at the bus and the interrupt lines.
#include <verilated.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <stdexcept>
#include <utility>
#include <vector>

#include "sim/processor/processor_model.hpp"
#include "sim/replay/chip_registers.hpp"
#include "sim/replay/processor_snapshot.hpp"
#include "sim/simulation/chip_model.hpp"
#include "sim/simulation/model_clocks.hpp"
#include "sim/simulation/model_pins.hpp"
#include "Vchip_without_processor.h"
#include "Vchip_without_processor___024root.h"

STEPFABRIC_MODEL_FUNCTIONS(Vchip_without_processor)

namespace sim {

namespace {

constexpr unsigned timer_interrupt_bit = 7, first_interrupt_bit = 16;
// From reset at the pin to the processor's first clock without it.
constexpr Clock clocks_of_reset = 2;
// With interrupts enabled this much may have to be repeated.
constexpr Clock longest_lead = 400;
// The effects of a sleep or a changed line in the netlist have ended after this time.
constexpr Clock settling_clocks = 8;

// The processor runs ahead to its next access of the bus, or to where the simulation looks at it;
// the netlist follows. Where an interrupt line changes meanwhile the processor is taken back.
class JoinedModel : public ChipModel {
 public:
  JoinedModel(std::uint32_t clock_hz, Edges edges);
  // A model is removed from the context of the thread, which of several chips may
  // be another's.
  ~JoinedModel() override { Verilated::threadContextp(context_.get()); }

  void permit_software_stepping() override;
  void set_memory_bytes(std::uint32_t bytes) override;
  void count_into(EvaluationCounts& counts) override { clocks_->count_into(counts); }
  void advance(Clock limit) override;
  void reset() override;
  std::uint32_t read_memory(std::uint32_t address) const override;
  void write_memory(std::uint32_t address, std::uint32_t word) override;
  QueueStatistics queue_statistics() const override {
    return sampled_queue_statistics(std::as_const(*model_->rootp));
  }
  ProcessorStatistics processor_statistics() const override;
  bool takes_snapshots() const override { return true; }
  std::optional<replay::Snapshot> snapshot() const override;
  void trace_to(const std::string&) override {
    throw std::runtime_error("the model of the processor writes no waveforms");
  }

 private:
  using Model = Vchip_without_processor;

  void start();
  void hold_reset();
  void set_inputs();
  void let_processor_run(Clock limit);
  bool serve_bus(Clock edge);
  void look_at_interrupts();
  bool sleeps() const;
  Clock next_stop(Clock limit) const;

  std::unique_ptr<VerilatedContext> context_ = std::make_unique<VerilatedContext>();
  std::unique_ptr<Model> model_ = std::make_unique<Model>(context_.get());
  std::unique_ptr<ModelClocks<Model>> clocks_;
  std::unique_ptr<processor::ProcessorModel> processor_ =
      std::make_unique<processor::ProcessorModel>(CHIP_MEMORY_BYTES, CHIP_HAS_ZBB);
  std::vector<replay::Register> registers_ = replay::registers_without_processor(*model_->rootp);
  InputPins set_inputs_;  // those that the model has
  std::uint32_t lines_ = 0;
  bool started_ = false;
  bool bus_is_busy_ = false;  // with an access whose request the netlist has
};

JoinedModel::JoinedModel(std::uint32_t clock_hz, Edges edges) {
  model_->clock_frequency_hz = clock_hz;
  model_->software_stepping = 0;
  model_->reset = 1;
  clocks_ = std::make_unique<ModelClocks<Model>>(*model_, edges);
  hold_reset();
  outputs_ = sampled_output_pins(std::as_const(*model_));
}

void JoinedModel::permit_software_stepping() {
  model_->software_stepping = 1;
  processor_ = std::make_unique<processor::ProcessorModel>(COMPARISON_MEMORY_BYTES, CHIP_HAS_ZBB);
}

void JoinedModel::set_memory_bytes(std::uint32_t bytes) {
  processor_ = std::make_unique<processor::ProcessorModel>(bytes, CHIP_HAS_ZBB);
}

void JoinedModel::set_inputs() {
  set_input_pins(*model_, inputs_);
  set_inputs_ = inputs_;
}

void JoinedModel::hold_reset() {
  set_inputs();
  model_->outer_request_strobe = 0;
  bus_is_busy_ = false;
  for (int i = 0; i < reset_clocks; ++i) clocks_->clock(true);
}

void JoinedModel::reset() {
  processor_->bring_to(now_);
  started_ = false;
  model_->reset = 1;
  hold_reset();
  outputs_ = sampled_output_pins(std::as_const(*model_));
}

void JoinedModel::start() {
  started_ = true;
  hold_reset();
  model_->reset = 0;
  processor_->reset(now_ + clocks_of_reset);
  lines_ = 0;
  look_at_interrupts();
}

void JoinedModel::let_processor_run(Clock limit) {
  if (processor_->accesses()) return;
  const ActivityScope scope(Activity::processor_model);
  if (processor_->complete() > now_) return;
  processor_->mark();
  processor_->run(processor_->interrupts_matter() ? std::min(limit, now_ + longest_lead) : limit);
}

// As far as nothing but the netlist's own events is to be looked at.
Clock JoinedModel::next_stop(Clock limit) const {
  if (bus_is_busy_) return now_;
  if (processor_->accesses()) return std::min(limit, processor_->access_clock() - 1);
  return std::min(limit, processor_->complete());
}

// Applies the processor's outputs to the bus at this edge. Returns whether they changed.
bool JoinedModel::serve_bus(Clock edge) {
  Model& model = *model_;
  if (bus_is_busy_) {
    if (model.outer_response_acknowledge == 0 && model.outer_response_error == 0) return false;
    bus_is_busy_ = false;
    model.outer_request_strobe = 0;
    processor_->complete_access(edge, model.outer_response_error != 0, model.outer_response_data);
    return true;
  }
  if (!processor_->accesses() || processor_->access_clock() != edge) return false;
  const processor::BusAccess& access = processor_->access();
  model.outer_request_strobe = 1;
  model.outer_request_write = access.write;
  model.outer_request_address = access.address;
  model.outer_request_select_bytes = access.lanes;
  model.outer_request_data = access.data;
  bus_is_busy_ = true;
  return true;
}

void JoinedModel::look_at_interrupts() {
  const std::uint32_t lines = std::uint32_t{model_->outer_timer_interrupt} << timer_interrupt_bit |
                              std::uint32_t{model_->outer_interrupts} << first_interrupt_bit;
  if (lines == lines_) return;
  lines_ = lines;
  const ActivityScope scope(Activity::processor_model);
  processor_->set_interrupts(now_, lines);
}

void JoinedModel::advance(Clock limit) {
  bool input_has_changed = inputs_ != set_inputs_;
  if (!started_) {
    start();
    input_has_changed = true;
  }
  if (input_has_changed) set_inputs();
  Model& model = *model_;
  const OutputPins before = outputs_;
  while (now_ < limit) {
    let_processor_run(limit);
    const Clock stop = next_stop(limit);
    const bool fan_gate = model.fan_gate;
    bool others = false;
    if (const Clock leap =
            !input_has_changed && stop > now_
                ? clocks_->leap(stop - now_, stop < limit ? LeapEnd::processor : LeapEnd::device)
                : Clock{0};
        leap != 0) {
      now_ += leap;
    } else {
      const bool for_processor = serve_bus(now_ + 1);
      others = clocks_->clock(input_has_changed, for_processor);
      input_has_changed = false;
      ++now_;
      if (others) look_at_interrupts();
    }
    // The fan's is the only pin that `clk` alone changes.
    if (others || model.fan_gate != fan_gate) {
      outputs_ = sampled_output_pins(std::as_const(model));
      if (outputs_ != before) return;
    }
  }
}

std::uint32_t JoinedModel::read_memory(std::uint32_t address) const {
  if (started_) processor_->bring_to(now_);
  return processor_->read_memory(address);
}

void JoinedModel::write_memory(std::uint32_t address, std::uint32_t word) {
  if (started_) processor_->bring_to(now_);
  processor_->write_memory(address, word);
}

ProcessorStatistics JoinedModel::processor_statistics() const {
  if (started_) processor_->bring_to(now_);
  const processor::MachineState& state = processor_->state();
  return {.sleeping_clocks = processor_->sleeping_clocks(now_),
          .instructions = state.instructions,
          .program_counter = state.program_counter,
          .begins = static_cast<std::uint64_t>(state.begins),
          .accesses = state.accesses};
}

// After some clocks, and permanently: with a deadline of the timer in the next clock the netlist of
// the whole chip would not fall asleep.
bool JoinedModel::sleeps() const {
  const processor::MachineState& state = processor_->state();
  return state.asleep && model_->at_rest_processor != 0 && state.begins + settling_clocks <= now_ &&
         state.lines == lines_ && state.lines_seen + settling_clocks <= now_ &&
         (lines_ & state.interrupts_enabled) == 0;
}

std::optional<replay::Snapshot> JoinedModel::snapshot() const {
  if (started_ && !sleeps()) return std::nullopt;
  replay::Snapshot snapshot{.clock = now_,
                            .in_reset = !started_,
                            .processor = replay::snapshot_of(processor_->state(), now_),
                            .memory = {},
                            .registers = {},
                            .outputs = outputs_,
                            .statistics = processor_statistics()};
  // The netlist has no more; what uses the comparison's memory differs there from the first use on.
  for (std::uint32_t place = 0; place < CHIP_MEMORY_BYTES; place += 4) {
    snapshot.memory.push_back(
        processor_->read_memory(processor::ProcessorModel::memory_start + place));
  }
  for (const replay::Register& chip_register : registers_) {
    std::ranges::copy(chip_register.contents(), std::back_inserter(snapshot.registers));
  }
  return snapshot;
}

}  // namespace

std::unique_ptr<ChipModel> make_joined_model(std::uint32_t clock_hz, Edges edges) {
  return std::make_unique<JoinedModel>(clock_hz, edges);
}

}  // namespace sim
