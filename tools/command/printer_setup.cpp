// SPDX-License-Identifier: Apache-2.0
// Putting chip, firmware and printer together.
#include "tools/command/printer_setup.hpp"

#include "sim/machine/thermal_properties.hpp"
#include "tools/command/build.hpp"

namespace command {

namespace {

sim::ElfImage built_firmware(const std::string& stepping) {
  const bool software = stepping == "software";
  build({software ? "firmware_software_stepping" : "firmware"});
  return sim::read_elf(build_folder() / "firmware" /
                       (software ? "software_stepping.elf" : "firmware.elf"));
}

}  // namespace

std::filesystem::path default_machine() {
  return project_folder() / "firmware" / "machines" / "prusa_mendel.toml";
}

PrinterSetup::PrinterSetup(const PrinterChoices& choices, const StartTemperatures& warm)
    : description_(
          machine::read_description(choices.machine.empty() ? default_machine() : choices.machine)),
      firmware_(built_firmware(choices.stepping)),
      chip_(choices.clock_hz),
      simulation_(chip_, sim::ClockRate(choices.clock_hz)),
      baud_(choices.baud.value_or(description_.baud)) {
  sim::load(firmware_, chip_);
  machine::PrinterOptions options{.baud = baud_,
                                  .seed = choices.seed,
                                  .hotend_start_c = machine::ambient_celsius,
                                  .bed_start_c = machine::ambient_celsius,
                                  .faults = {}};
  if (choices.warm) {
    options.hotend_start_c = warm.hotend_c;
    options.bed_start_c = warm.bed_c;
  }
  for (const std::string& fault : choices.faults) {
    machine::add_fault(options.faults, fault);
  }
  printer_.emplace(description_, options, simulation_);
}

}  // namespace command
