// SPDX-License-Identifier: Apache-2.0
// Pins, clocks and memory of the Verilated chip.
#include "sim/simulation/verilated_chip.hpp"

#include <fmt/format.h>
#include <verilated.h>

#include <array>
#include <cstdint>
#include <utility>

#include "sim/simulation/model_clocks.hpp"
#include "sim/simulation/trace.hpp"

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

constexpr std::uint32_t memory_start = 0x8000'0000;
constexpr int reset_clocks = 8;

}  // namespace

class VerilatedChip::Clocks : public ModelClocks<Vprinter_core> {
  using ModelClocks::ModelClocks;
};

VerilatedChip::VerilatedChip(std::uint32_t clock_hz, Edges edges)
    : context_(std::make_unique<VerilatedContext>()) {
  permit_tracing(*context_);
  model_ = std::make_unique<Vprinter_core>(context_.get());
  model_->clock_frequency_hz = clock_hz;
  model_->software_stepping = 0;
  model_->reset = 1;
  clocks_ = std::make_unique<Clocks>(*model_, edges);
  hold_reset();
  outputs_ = sampled_outputs();
}

VerilatedChip::~VerilatedChip() {
  // A model takes its leave from the context of the thread, which of several chips may be
  // another's.
  Verilated::threadContextp(context_.get());
}

void VerilatedChip::permit_software_stepping() { model_->software_stepping = 1; }

void VerilatedChip::hold_reset() {
  set_inputs();
  for (int i = 0; i < reset_clocks; ++i) {
    clocks_->clock(true);
  }
}

void VerilatedChip::set_inputs() {
  model_->receive = inputs_.receive;
  model_->end_stop = inputs_.end_stops;
  model_->sensor_sense = inputs_.sense;
  model_->emergency_stop = inputs_.emergency_stop;
  model_->tck = inputs_.jtag.tck;
  model_->tms = inputs_.jtag.tms;
  model_->tdi = inputs_.jtag.tdi;
  set_inputs_ = inputs_;
}

OutputPins VerilatedChip::sampled_outputs() const {
  const Vprinter_core& model = *model_;
  constexpr unsigned channel_pins = 3, channel_mask = 7;
  std::uint64_t word = std::uint64_t{model.step} << OutputPins::step_bit |
                       std::uint64_t{model.direction} << OutputPins::direction_bit |
                       std::uint64_t{model.motor_enable} << OutputPins::enable_bit |
                       std::uint64_t{model.transmit} << OutputPins::transmit_bit |
                       std::uint64_t{model.fan_gate} << OutputPins::fan_bit |
                       std::uint64_t{model.heater_gate} << OutputPins::heater_bit |
                       std::uint64_t{model.heater_supply} << OutputPins::heater_supply_bit |
                       std::uint64_t{model.fault} << OutputPins::fault_bit |
                       std::uint64_t{model.tdo} << OutputPins::jtag_bit;
  for (unsigned channel = 0; channel < sensor_count; ++channel) {
    const std::uint64_t drive =
        model.sensor_drive_enable >> (channel_pins * channel) & channel_mask;
    const std::uint64_t level = model.sensor_drive_level >> (channel_pins * channel) & channel_mask;
    word |= (drive | level << OutputPins::sensor_level_bit)
            << (OutputPins::sensor_bit + 8 * channel);
  }
  return {word};
}

void VerilatedChip::advance(Clock limit) {
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
      if (trace_) {
        trace_->record(now_);
      }
    }
    // The fan's is the only pin that the free-running clock alone changes.
    if (others || model.fan_gate != fan_gate) {
      outputs_ = sampled_outputs();
      if (outputs_ != before) {
        return;
      }
    }
  }
}

void VerilatedChip::reset() {
  started_ = false;
  model_->reset = 1;
  hold_reset();
  outputs_ = sampled_outputs();
}

namespace {

// Each bank of the memory has a lane for each byte of a word.
#define RAM(part) printer_core__DOT__with_processor_computing__DOT__ram__DOT__##part##_bytes

template <typename Root>
auto lower_lanes(Root& root) {
  return std::array{&root.RAM(lanes_n1), &root.RAM(lanes_n2), &root.RAM(lanes_n3),
                    &root.RAM(lanes_n4)};
}

template <typename Root>
auto upper_lanes(Root& root) {
  return std::array{&root.RAM(two_banks_upper_lanes_n1), &root.RAM(two_banks_upper_lanes_n2),
                    &root.RAM(two_banks_upper_lanes_n3), &root.RAM(two_banks_upper_lanes_n4)};
}

constexpr std::size_t lower_words = sizeof(Vprinter_core___024root::RAM(lanes_n1));
constexpr std::size_t upper_words = sizeof(Vprinter_core___024root::RAM(two_banks_upper_lanes_n1));

// The word's byte in each lane.
template <typename Root>
auto bytes_of_word(Root& root, std::uint32_t address) {
  const std::uint32_t index = (address - memory_start) / 4;
  if (address < memory_start || index >= lower_words + upper_words) {
    throw std::out_of_range(fmt::format("no memory at {:#010x}", address));
  }
  using Byte = std::remove_reference_t<decltype((*lower_lanes(root)[0])[0])>;
  std::array<Byte*, 4> bytes{};
  for (std::size_t lane = 0; lane < bytes.size(); ++lane) {
    bytes[lane] = index < lower_words ? &(*lower_lanes(root)[lane])[index]
                                      : &(*upper_lanes(root)[lane])[index - lower_words];
  }
  return bytes;
}

#undef RAM

}  // namespace

std::uint32_t VerilatedChip::read_memory(std::uint32_t address) const {
  std::uint32_t word = 0;
  unsigned shift = 0;
  for (const auto* byte : bytes_of_word(std::as_const(*model_->rootp), address)) {
    word |= std::uint32_t{*byte} << shift;
    shift += 8;
  }
  return word;
}

void VerilatedChip::write_memory(std::uint32_t address, std::uint32_t word) {
  for (auto* byte : bytes_of_word(*model_->rootp, address)) {
    *byte = static_cast<std::uint8_t>(word);
    word >>= 8;
  }
}

QueueStatistics VerilatedChip::queue_statistics() const {
  const Vprinter_core___024root& root = *model_->rootp;
  return {root.printer_core__DOT__motion__DOT__generator__DOT__core__DOT__underruns,
          root.printer_core__DOT__motion__DOT__generator__DOT__core__DOT__stalls,
          root.printer_core__DOT__motion__DOT__generator__DOT__core__DOT__level,
          root.printer_core__DOT__motion__DOT__generator__DOT__core__DOT__max_level};
}

void VerilatedChip::trace_to(const std::string& file) { trace_ = make_trace(*model_, file); }

}  // namespace sim
