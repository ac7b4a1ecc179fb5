// SPDX-License-Identifier: Apache-2.0
// Pins, clocks and memory of the whole chip by its netlist.
#include "sim/simulation/netlist_model.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <stdexcept>
#include <utility>

#include "sim/simulation/memory_banks.hpp"

namespace sim {

NetlistModel::NetlistModel(std::uint32_t clock_hz, Edges edges)
    : context_(std::make_unique<VerilatedContext>()) {
  permit_tracing(*context_);
  model_ = std::make_unique<Vprinter_core>(context_.get());
  model_->clock_frequency_hz = clock_hz;
  model_->software_stepping = 0;
  model_->reset = 1;
  clocks_ = std::make_unique<ModelClocks<Vprinter_core>>(*model_, edges);
  hold_reset();
  outputs_ = sampled_outputs();
}

NetlistModel::~NetlistModel() {
  // A model is removed from the context of the thread, which of several chips may
  // be another's.
  Verilated::threadContextp(context_.get());
}

void NetlistModel::hold_reset() {
  set_inputs();
  for (int i = 0; i < reset_clocks; ++i) clocks_->clock(true);
}

void NetlistModel::set_inputs() {
  set_input_pins(*model_, inputs_);
  set_inputs_ = inputs_;
}

void NetlistModel::advance(Clock limit) {
  bool input_has_changed = inputs_ != set_inputs_;
  if (!started_) {
    started_ = true;
    hold_reset();  // with the program in memory, so that nothing old has been fetched
    model_->reset = 0;
    input_has_changed = true;
  }
  set_inputs();
  Vprinter_core& model = *model_;
  const OutputPins before = outputs_;
  while (now_ < limit) {
    const bool fan_gate = model.fan_gate;
    bool others = false;
    if (const Clock leap = !input_has_changed && !trace_ ? clocks_->leap(limit - now_) : 0;
        leap != 0) {
      now_ += leap;
      processor_.sleeping_clocks += model.sleeping ? leap : 0;
    } else {
      others = clocks_->clock(input_has_changed);
      input_has_changed = false;
      ++now_;
      processor_.sleeping_clocks += model.sleeping;
      processor_.instructions += model.retired;
      if (trace_) trace_->record(now_);
    }
    // The fan's is the only pin that `clk` alone changes.
    if (others || model.fan_gate != fan_gate) {
      outputs_ = sampled_outputs();
      if (outputs_ != before) return;
    }
  }
}

void NetlistModel::reset() {
  started_ = false;
  model_->reset = 1;
  hold_reset();
  outputs_ = sampled_outputs();
}

namespace {

// Each bank of the memory has a lane for each byte of a word.
#define RAM(part) printer_core__DOT__with_processor_computing__DOT__ram__DOT__##part##_bytes

template <typename Root>
auto bytes_at(Root& root, std::uint32_t address) {
  return bytes_of_word(address, STEPFABRIC_MEMORY_LANE(root, n1), STEPFABRIC_MEMORY_LANE(root, n2),
                       STEPFABRIC_MEMORY_LANE(root, n3), STEPFABRIC_MEMORY_LANE(root, n4));
}

#undef RAM

}  // namespace

std::uint32_t NetlistModel::read_memory(std::uint32_t address) const {
  std::uint32_t word = 0;
  unsigned shift = 0;
  for (const auto* byte : bytes_at(std::as_const(*model_->rootp), address)) {
    word |= std::uint32_t{*byte} << shift;
    shift += 8;
  }
  return word;
}

void NetlistModel::write_memory(std::uint32_t address, std::uint32_t word) {
  for (auto* byte : bytes_at(*model_->rootp, address)) {
    *byte = static_cast<std::uint8_t>(word);
    word >>= 8;
  }
}

std::unique_ptr<ChipModel> make_netlist_model(std::uint32_t clock_hz, Edges edges) {
  return std::make_unique<NetlistModel>(clock_hz, edges);
}

}  // namespace sim
