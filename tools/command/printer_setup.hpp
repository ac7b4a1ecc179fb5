// SPDX-License-Identifier: Apache-2.0
// What `print` and `serve` share: the chip with its firmware on the simulated printer.
#pragma once

#include <optional>

#include "sim/machine/printer.hpp"
#include "sim/simulation/elf_image.hpp"
#include "sim/simulation/verilated_chip.hpp"
#include "tools/command/print_job.hpp"

namespace command {

struct StartTemperatures {
  double hotend_c{};
  double bed_c{};
};

// Of the machine that was chosen. Throws std::runtime_error where it cannot be read.
machine::Description description_of(const PrinterChoices& choices);
// Whether it has two extruders, and so more heaters than the default chip; false where it cannot be
// read, which the job then says.
bool has_two_extruders(const PrinterChoices& choices);

// Builds the firmware and reads the machine description: throws std::runtime_error
// where that fails.
class PrinterSetup {
 public:
  // `warm` counts where the choices request a warm start.
  PrinterSetup(const PrinterChoices& choices, const StartTemperatures& warm);

  const sim::ElfImage& firmware() const { return firmware_; }
  sim::VerilatedChip& chip() { return chip_; }
  sim::Simulation& simulation() { return simulation_; }
  machine::Printer& printer() { return *printer_; }
  std::uint32_t baud() const { return baud_; }
  // Writes into the loaded firmware how fast its end of the line is. After each load.
  void set_speed_of_line();
  void set_memory(bool software_stepping);

 private:
  machine::Description description_;
  sim::ElfImage firmware_;
  sim::VerilatedChip chip_;
  sim::Simulation simulation_;
  std::uint32_t baud_;
  std::optional<machine::Printer> printer_;
};

std::filesystem::path default_machine();

}  // namespace command
