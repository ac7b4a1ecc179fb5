// SPDX-License-Identifier: Apache-2.0
// Pins and clocks of the netlist's model, whose names are in the header BOARD_NAMES.
#include "tests/netlist/netlist_chip.hpp"

#include <verilated.h>

#include <stdexcept>

#include BOARD_NAMES

namespace tests {

using sim::OutputPins;

namespace {

// ulx3s.vhd, cyclone_board.vhd: from the first clock on with a locked loop.
constexpr int reset_clocks = 16;
constexpr unsigned fault_lamp = 0, awake_lamp = 1;
constexpr unsigned all_axes = (1U << sim::axis_count) - 1;

}  // namespace

NetlistChip::NetlistChip()
    : context_(std::make_unique<VerilatedContext>()),
      model_(std::make_unique<BoardNetlist>(context_.get())) {
  set_inputs();
  model_->eval();  // Initial values: the first rise of the clock must be one.
  for (int i = 0; i < reset_clocks; ++i) clock();
  outputs_ = sampled_outputs();
}

NetlistChip::~NetlistChip() {
  // As VerilatedChip's.
  Verilated::threadContextp(context_.get());
}

void NetlistChip::clock() {
  if (++watch_phase_ == board::watch_clocks) {
    watch_phase_ = 0;
    board::change_watch_clock(*model_);
  }
  board::set_clock(*model_, true);
  model_->eval();
  board::set_clock(*model_, false);
  model_->eval();
}

void NetlistChip::set_inputs() {
  board::set_receive(*model_, inputs_.receive);
  model_->end_stop = inputs_.end_stops;
  model_->sensor_sense = inputs_.sense;
  model_->emergency_stop = inputs_.emergency_stop;
  model_->tck = inputs_.jtag.tck;
  model_->tms = inputs_.jtag.tms;
  model_->tdi = inputs_.jtag.tdi;
}

OutputPins NetlistChip::sampled_outputs() const {
  const BoardNetlist& model = *model_;
  constexpr unsigned channel_pins = 3, channel_mask = 7;
  std::uint64_t word = std::uint64_t{model.step} << OutputPins::step_bit |
                       std::uint64_t{model.direction} << OutputPins::direction_bit |
                       std::uint64_t{~model.motor_enable_n & all_axes} << OutputPins::enable_bit |
                       std::uint64_t{board::transmit(model)} << OutputPins::transmit_bit |
                       std::uint64_t{model.fan_gate} << OutputPins::fan_bit |
                       std::uint64_t{model.heater_gate} << OutputPins::heater_bit |
                       std::uint64_t{model.heater_supply} << OutputPins::heater_supply_bit |
                       std::uint64_t{model.led >> fault_lamp & 1U} << OutputPins::fault_bit |
                       std::uint64_t{model.tdo} << OutputPins::jtag_bit;
  for (unsigned channel = 0; channel < sim::sensor_count; ++channel) {
    const std::uint64_t drive =
        model.sensor_resistor_driven >> (channel_pins * channel) & channel_mask;
    const std::uint64_t level =
        model.sensor_resistor_level >> (channel_pins * channel) & channel_mask;
    word |= (drive | (level & drive) << OutputPins::sensor_level_bit)
            << (OutputPins::sensor_bit + 8 * channel);
  }
  return {word};
}

void NetlistChip::advance(sim::Clock limit) {
  set_inputs();
  const OutputPins before = outputs_;
  while (now_ < limit && outputs_ == before) {
    clock();
    ++now_;
    processor_.sleeping_clocks += (model_->led >> awake_lamp & 1) == 0;
    outputs_ = sampled_outputs();
  }
}

void NetlistChip::reset() { throw std::logic_error("the board has no reset"); }

std::uint32_t NetlistChip::read_memory(std::uint32_t) const {
  throw std::logic_error("the netlist's memory has no addresses");
}

void NetlistChip::write_memory(std::uint32_t, std::uint32_t) {
  throw std::logic_error("the netlist's memory has no addresses");
}

void NetlistChip::trace_to(const std::string&) {
  throw std::runtime_error("the netlist's model writes no waveforms");
}

}  // namespace tests
