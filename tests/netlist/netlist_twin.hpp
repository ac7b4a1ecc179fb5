// SPDX-License-Identifier: Apache-2.0
// The netlist of the board in step with the model of the chip that it was made of.
#pragma once

#include "sim/simulation/verilated_chip.hpp"
#include "tests/chip/twins.hpp"
#include "tests/netlist/netlist_chip.hpp"

namespace tests {

// The board's pins for power and steps come from registers in the pads: a clock after the model's.
// The program is written into the model's memory only; the netlist has its own.
class NetlistTwin : public Twins {
 public:
  explicit NetlistTwin(std::uint32_t clock_hz);

  // The lamp shows it in every clock.
  std::uint64_t netlist_sleeping_clocks() const {
    return netlist_.processor_statistics().sleeping_clocks;
  }

 private:
  void advance(sim::Clock limit) override;
  sim::OutputPins expected_outputs() const override;

  sim::VerilatedChip model_;
  NetlistChip netlist_;
  // The model's pins in the clock before.
  sim::OutputPins earlier_;
};

}  // namespace tests
