// SPDX-License-Identifier: Apache-2.0
// Pins and clock of the netlist's model.
#include "tests/netlist/netlist_chip.hpp"

#include <verilated.h>

#include <stdexcept>

#include "Vulx3s.h"
#include "Vulx3s___024root.h"

namespace tests {

using sim::OutputPins;

namespace {

// ulx3s.vhd: from the first clock on with a locked loop.
constexpr int reset_clocks = 16;
constexpr unsigned fault_lamp = 0, awake_lamp = 1;
// 50 MHz against half of 2.4: the oscillator changes its level so seldom.
constexpr unsigned oscillator_clocks = 10;
constexpr unsigned all_axes = (1U << sim::axis_count) - 1;

}  // namespace

NetlistChip::NetlistChip()
    : context_(std::make_unique<VerilatedContext>()),
      model_(std::make_unique<Vulx3s>(context_.get())) {
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
  if (++oscillator_phase_ == oscillator_clocks) {
    oscillator_phase_ = 0;
    model_->rootp->ulx3s__DOT__oscillator_0__DOT__level ^= 1;
  }
  model_->clk_25mhz = 1;
  model_->eval();
  model_->clk_25mhz = 0;
  model_->eval();
}

void NetlistChip::set_inputs() {
  model_->ftdi_txd = inputs_.receive;
  model_->ftdi_ndtr = 0;  // a host has the port open
  model_->end_stop = inputs_.end_stops;
  model_->sensor_sense = inputs_.sense;
  model_->emergency_stop = inputs_.emergency_stop;
  model_->tck = inputs_.jtag.tck;
  model_->tms = inputs_.jtag.tms;
  model_->tdi = inputs_.jtag.tdi;
}

OutputPins NetlistChip::sampled_outputs() const {
  const Vulx3s& model = *model_;
  constexpr unsigned channel_pins = 3, channel_mask = 7;
  std::uint64_t word = std::uint64_t{model.step} << OutputPins::step_bit |
                       std::uint64_t{model.direction} << OutputPins::direction_bit |
                       std::uint64_t{~model.motor_enable_n & all_axes} << OutputPins::enable_bit |
                       std::uint64_t{model.ftdi_rxd} << OutputPins::transmit_bit |
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
