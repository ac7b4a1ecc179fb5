// SPDX-License-Identifier: Apache-2.0
// A chip with a program in it, on a printer at room temperature, or with a hot hotend.
#pragma once

#include <cstdint>

#include "sim/machine/printer.hpp"
#include "sim/simulation/simulation.hpp"
#include "sim/simulation/verilated_chip.hpp"

namespace benchmarks {

struct ColdPrinter {
  static constexpr double room_c = 25;

  ColdPrinter(const sim::ElfImage& firmware, const machine::Description& description,
              std::uint32_t clock_hz, std::uint32_t baud, double hotend_c = room_c)
      : chip(clock_hz),
        simulation(chip, sim::ClockRate(clock_hz)),
        printer(description,
                {.baud = baud, .hotend_start_c = hotend_c, .bed_start_c = room_c, .faults = {}},
                simulation) {
    if (description.memory_bytes) chip.set_memory_bytes(*description.memory_bytes);
    sim::load(firmware, chip);
  }

  sim::VerilatedChip chip;
  sim::Simulation simulation;
  machine::Printer printer;
};

}  // namespace benchmarks
