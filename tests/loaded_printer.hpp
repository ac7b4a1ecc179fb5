// SPDX-License-Identifier: Apache-2.0
// The default machine with the firmware of this build in its chip.
#pragma once

#include <cstdint>

#include "directories.hpp"
#include "sim/machine/printer.hpp"
#include "sim/simulation/elf_image.hpp"
#include "tests/default_machine.hpp"

namespace tests {

inline constexpr const char* firmware_file = BUILD_DIRECTORY "/firmware/firmware.elf";

// The heaters start at these temperatures.
struct LoadedPrinter {
  LoadedPrinter(sim::Chip& chip, std::uint32_t clock_hz, double hotend_c, double bed_c,
                const machine::FaultPlan& faults = {})
      : description(default_machine()),
        simulation(chip, sim::ClockRate(clock_hz)),
        printer(description,
                {.baud = description.baud,
                 .hotend_start_c = hotend_c,
                 .bed_start_c = bed_c,
                 .faults = faults},
                simulation) {
    sim::load(sim::read_elf(firmware_file), chip);
  }

  machine::Description description;
  sim::Simulation simulation;
  machine::Printer printer;
};

}  // namespace tests
