// SPDX-License-Identifier: Apache-2.0
// Pins, clocks and memory of a board's top entity, whose names are in the header BOARD_NAMES;
// BOARD_CLOCK_HZ is the clock that the model was made for.
#include "sim/boards/board_model.hpp"

#include <fmt/format.h>

#include <array>
#include <stdexcept>
#include <utility>

#include "sim/simulation/memory_banks.hpp"
#include BOARD_NAMES

#define IN_QUEUE(name) IN_CORE(motion__DOT__generator__DOT__core__DOT__##name)
#define RAM(part) IN_CORE(with_processor_computing__DOT__ram__DOT__##part##_bytes)

namespace sim {
namespace {

constexpr unsigned fault_lamp = 0;
// From power-up to the end of the reset, at most: the loop locks, and 16 clocks.
constexpr int most_reset_clocks = 64;

template <typename Root>
auto bytes_at(Root& root, std::uint32_t address) {
  return bytes_of_word(address, STEPFABRIC_MEMORY_LANE(root, n1), STEPFABRIC_MEMORY_LANE(root, n2),
                       STEPFABRIC_MEMORY_LANE(root, n3), STEPFABRIC_MEMORY_LANE(root, n4));
}

}  // namespace

BoardModel::BoardModel(std::uint32_t clock_hz)
    : context_(std::make_unique<VerilatedContext>()),
      model_(std::make_unique<Vboard>(context_.get())) {
  if (clock_hz != BOARD_CLOCK_HZ) {
    throw std::runtime_error(
        fmt::format("the model of this board has a clock of {} Hz", BOARD_CLOCK_HZ));
  }
  board::set_clock(*model_, false);
  set_inputs();
  model_->eval();  // What is there after configuration.
  outputs_ = sampled_outputs();
}

BoardModel::~BoardModel() {
  // As NetlistModel's.
  Verilated::threadContextp(context_.get());
}

void BoardModel::permit_software_stepping() {
  throw std::runtime_error("a board lets no firmware drive the step pins");
}

void BoardModel::set_memory_bytes(std::uint32_t) {
  throw std::runtime_error("the board's chip has no more memory");
}

// With the program in memory, as on a board.
void BoardModel::start() {
  started_ = true;
  for (int clocks = 0; !board::is_released(*model_); ++clocks) {
    if (clocks == most_reset_clocks) throw std::runtime_error("the board's reset does not end");
    clock();
  }
  outputs_ = sampled_outputs();
}

void BoardModel::clock() {
  board::set_clock(*model_, true);
  model_->eval();
  board::set_clock(*model_, false);
  if (++watch_phase_ == board::watch_clocks) {
    watch_phase_ = 0;
    board::change_watch_clock(*model_);
  }
  model_->eval();
}

void BoardModel::set_inputs() {
  board::set_receive(*model_, inputs_.receive);
  board::set_end_stops(*model_, inputs_.end_stops);
  model_->sensor_sense = inputs_.sense;
  model_->emergency_stop = inputs_.emergency_stop;
  model_->tck = inputs_.jtag.tck;
  model_->tms = inputs_.jtag.tms;
  model_->tdi = inputs_.jtag.tdi;
}

OutputPins BoardModel::sampled_outputs() const {
  const Vboard& model = *model_;
  const board::Motors motors = board::motors_of(model);
  constexpr unsigned channel_pins = 3, channel_mask = 7;
  std::uint64_t word = motors.step << OutputPins::step_bit |
                       motors.direction << OutputPins::direction_bit |
                       motors.enabled << OutputPins::enable_bit |
                       std::uint64_t{board::transmit(model)} << OutputPins::transmit_bit |
                       std::uint64_t{model.fan_gate} << OutputPins::fan_bit |
                       std::uint64_t{model.heater_gate} << OutputPins::heater_bit |
                       std::uint64_t{model.heater_supply} << OutputPins::heater_supply_bit |
                       std::uint64_t{model.led >> fault_lamp & 1U} << OutputPins::fault_bit |
                       std::uint64_t{model.tdo} << OutputPins::jtag_bit;
  // A pin that is left open has no level.
  const unsigned driven = model.rootp->IN_BOARD(drive_enable), level = model.sensor_resistor;
  for (unsigned channel = 0; channel < sensor_count; ++channel) {
    const std::uint64_t drive = driven >> (channel_pins * channel) & channel_mask;
    const std::uint64_t high = level >> (channel_pins * channel) & drive;
    word |= (drive | high << OutputPins::sensor_level_bit)
            << (OutputPins::sensor_bit + 8 * channel);
  }
  return {word};
}

void BoardModel::advance(Clock limit) {
  set_inputs();
  if (!started_) start();
  const OutputPins before = outputs_;
  while (now_ < limit && outputs_ == before) {
    clock();
    ++now_;
    processor_.sleeping_clocks += model_->rootp->IN_CORE(sleeping);
    processor_.instructions += model_->rootp->IN_CORE(retired);
    outputs_ = sampled_outputs();
  }
}

void BoardModel::reset() { throw std::logic_error("the board has no reset"); }

std::uint32_t BoardModel::read_memory(std::uint32_t address) const {
  std::uint32_t word = 0;
  unsigned shift = 0;
  for (const auto* byte : bytes_at(std::as_const(*model_->rootp), address)) {
    word |= std::uint32_t{*byte} << shift;
    shift += 8;
  }
  return word;
}

void BoardModel::write_memory(std::uint32_t address, std::uint32_t word) {
  for (auto* byte : bytes_at(*model_->rootp, address)) {
    *byte = static_cast<std::uint8_t>(word);
    word >>= 8;
  }
}

QueueStatistics BoardModel::queue_statistics() const {
  const Vboard___024root& root = *model_->rootp;
  return {root.IN_QUEUE(underruns), root.IN_QUEUE(stalls), root.IN_QUEUE(level),
          root.IN_QUEUE(max_level)};
}

void BoardModel::trace_to(const std::string&) {
  throw std::runtime_error("the model of a board writes no waveforms");
}

std::unique_ptr<ChipModel> make_netlist_model(std::uint32_t clock_hz, Edges) {
  return std::make_unique<BoardModel>(clock_hz);
}

}  // namespace sim
