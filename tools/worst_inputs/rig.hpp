// SPDX-License-Identifier: Apache-2.0
// The chip with its firmware, which measures its tasks itself, on a simulated printer.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sim/machine/printer.hpp"
#include "sim/simulation/elf_image.hpp"
#include "sim/simulation/verilated_chip.hpp"
#include "tools/timing/program.hpp"
#include "tools/worst_inputs/serial_input.hpp"
#include "units/task_span.hpp"

namespace worst_inputs {

// In clocks: each task's longest, and behind them that of the pass.
inline constexpr std::size_t pass_place = units::task_count;
using Slices = std::array<std::uint32_t, units::task_count + 1>;

class Rig {
 public:
  // The printer is homed, and its heaters are warm. The description must outlive the rig. No pass
  // of the firmware may take longer.
  Rig(const sim::ElfImage& firmware, const machine::Description& description,
      std::uint32_t clock_hz, sim::Clock longest_pass);

  // The longest time of each task from the first byte of an input on, until nothing of it is left
  // to be done, or for a while. Each meets the same printer, behind the same start, in a process of
  // its own, so many at once. Throws std::runtime_error with the input and what the simulation has
  // thrown, or where a pass has no end.
  std::vector<Slices> measure(const SerialInput& start, const std::vector<SerialInput>& inputs,
                              unsigned at_once);
  // The longest call of each of these functions in an input, in clocks, 0 without one. It is looked
  // at clock by clock, which takes longer.
  std::vector<std::uint64_t> longest_calls(const SerialInput& start, const SerialInput& input,
                                           const timing::Program& program, bool has_zbb,
                                           const std::vector<timing::Address>& functions);

 private:
  sim::Clock send(const SerialInput& input, sim::Clock end);
  Slices run(const SerialInput& input, sim::Clock end);
  std::string measure_here(const std::vector<SerialInput>& inputs, unsigned at_once);
  std::uint32_t word(std::uint32_t index) const;
  std::uint32_t lines_done() const;
  std::uint32_t lines_accepted() const;
  bool is_idle();
  bool is_asleep();
  bool is_in_boot_loader() const;
  sim::Clock clocks(double seconds) const;
  void run_for(sim::Clock clocks);
  void settle(int looks, sim::Clock end);
  void end_pass();

  sim::Clock longest_pass_;
  std::uint32_t statistics_, boot_loader_;
  std::function<void()> each_clock_;  // where it is set, called behind each one
  sim::VerilatedChip chip_;
  sim::Simulation simulation_;
  machine::Printer printer_;
};

}  // namespace worst_inputs
