// SPDX-License-Identifier: Apache-2.0
// Plays stimuli to the Verilated step generator, each in its clock, and notes the edges of
// its pins.
#pragma once

#include <Vstep_generator.h>

#include <vector>

#include "registers/step_generator_registers.hpp"
#include "tests/drivers/verilated_bus.hpp"
#include "tests/motion_reference/stimulus.hpp"

namespace tests {

using VerilatedStepGenerator = VerilatedPeripheral<Vstep_generator>;

class StepGeneratorReplay {
 public:
  explicit StepGeneratorReplay(const std::vector<motion_reference::Stimulus>& stimuli) {
    for (const motion_reference::Stimulus& stimulus : stimuli) {
      const bool write = stimulus.kind == motion_reference::Stimulus::Kind::write;
      (write ? writes_ : inputs_).push_back(stimulus);
    }
    chip_.after_clock = [this] {
      drive_inputs();
      watch();
    };
  }

  // Until this clock; returns all edges so far.
  const std::vector<motion_reference::Edge>& run(std::uint64_t clocks) {
    for (const motion_reference::Stimulus& write : writes_) {
      if (write.clock > chip_.now()) chip_.clock(write.clock - chip_.now());
      chip_.write(write.address, write.value);
    }
    writes_.clear();
    if (clocks > chip_.now()) chip_.clock(clocks - chip_.now());
    return edges_;
  }

 private:
  // An access takes two clocks, in the second of which an input may change.
  void drive_inputs() {
    for (; next_input_ < inputs_.size() && inputs_[next_input_].clock == chip_.now();
         ++next_input_) {
      const std::uint32_t value = inputs_[next_input_].value;
      chip_->end_stops = static_cast<std::uint8_t>(value & 0xFFu);
      chip_->emergency_stop = (value >> 8u & 1u) != 0;
      chip_->start = (value >> 9u & 1u) != 0;
    }
  }

  void watch() {
    const motion_reference::Pins pins{chip_->step, chip_->direction};
    if (pins == last_pins_) return;
    edges_.push_back({chip_.now(), pins});
    last_pins_ = pins;
  }

  std::vector<motion_reference::Stimulus> writes_, inputs_;
  std::size_t next_input_ = 0;
  VerilatedStepGenerator chip_{registers::step_generator::base};
  std::vector<motion_reference::Edge> edges_;
  motion_reference::Pins last_pins_{};
};

}  // namespace tests
