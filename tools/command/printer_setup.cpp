// SPDX-License-Identifier: Apache-2.0
// Putting chip, firmware and printer together.
#include "tools/command/printer_setup.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "sim/machine/surroundings.hpp"
#include "tools/command/build.hpp"

namespace command {

namespace {

sim::ElfImage built_firmware(const PrinterChoices& choices) {
  if (!choices.machine.empty()) return firmware_for(choices.machine, choices.stepping);
  const bool software = choices.stepping == "software";
  build({software ? "firmware_software_stepping" : "firmware"});
  return sim::read_elf(build_folder() / "firmware" /
                       (software ? "software_stepping.elf" : "firmware.elf"));
}

}  // namespace

std::filesystem::path default_machine() {
  return project_folder() / "firmware" / "machines" / "prusa_mendel.toml";
}

machine::Description description_of(const PrinterChoices& choices) {
  return machine::read_description(choices.machine.empty() ? default_machine() : choices.machine);
}

bool has_two_extruders(const PrinterChoices& choices) {
  if (choices.machine.empty()) return false;
  try {
    return description_of(choices).second_tool.has_value();
  } catch (const std::runtime_error&) {
    return false;
  }
}

PrinterSetup::PrinterSetup(const PrinterChoices& choices, const StartTemperatures& warm)
    : description_(description_of(choices)),
      firmware_(built_firmware(choices)),
      chip_(choices.clock_hz, choices.every_clock ? sim::Edges::all : sim::Edges::leaping,
            choices.every_clock ? sim::Processor::netlist : choices.processor),
      simulation_(chip_, sim::ClockRate(choices.clock_hz)),
      baud_(choices.baud.value_or(description_.baud)) {
  if (choices.stepping == "software") chip_.permit_software_stepping();
  set_memory(choices.stepping == "software");
  sim::load(firmware_, chip_);
  set_speed_of_line();
  machine::PrinterOptions options{.baud = baud_,
                                  .seed = choices.seed,
                                  .hotend_start_c = machine::ambient_celsius,
                                  .bed_start_c = machine::ambient_celsius,
                                  .faults = {}};
  if (choices.warm) {
    options.hotend_start_c = warm.hotend_c;
    options.bed_start_c = warm.bed_c;
  }
  for (const std::string& fault : choices.faults) machine::add_fault(options.faults, fault);
  printer_.emplace(description_, options, simulation_);
}

// A machine whose firmware is larger needs a chip with more memory.
void PrinterSetup::set_memory(bool software_stepping) {
  if (!description_.memory_bytes) return;
  const std::uint32_t present = software_stepping ? COMPARISON_MEMORY_BYTES : CHIP_MEMORY_BYTES;
  if (*description_.memory_bytes <= present) return;
  try {
    chip_.set_memory_bytes(*description_.memory_bytes);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(
        fmt::format("memory_kib of the machine is {}: {}; omit --processor netlist, --every-clock, "
                    "--trace and --board",
                    *description_.memory_bytes / 1024, error.what()));
  }
}

// Both ends of the line have the same speed.
void PrinterSetup::set_speed_of_line() {
  // The uart counts at least four clocks for a bit (rtl/serial).
  constexpr std::uint32_t least_clocks_per_bit = 4;
  const std::uint32_t clock_hz = simulation_.rate().hertz();
  if (baud_ > clock_hz / least_clocks_per_bit) {
    throw std::runtime_error(
        fmt::format("{} baud need a chip of at least {} Hz, and this one has {}: choose a lower "
                    "--baud or a higher --clock-hz",
                    baud_, baud_ * least_clocks_per_bit, clock_hz));
  }
  const std::optional<std::uint32_t> word = firmware_.symbol("serial_baud");
  if (!word) throw std::runtime_error("the firmware has no symbol `serial_baud`");
  chip_.write_memory(*word, baud_);
}

}  // namespace command
