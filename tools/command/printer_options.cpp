// SPDX-License-Identifier: Apache-2.0
// Options for the machine, the clock and the faults of the simulated printer.
#include "tools/command/printer_options.hpp"

#include <map>

#include "sim/machine/fault_plan.hpp"

namespace command {

void add_printer_options(CLI::App& job, PrinterChoices& choices) {
  job.add_option("--machine", choices.machine,
                 "description of the printer (TOML), for which its firmware is built too")
      ->type_name("FILE.toml");
  job.add_option("--baud", choices.baud,
                 "baud rate of the serial line, at both ends; default: the machine's. At most a "
                 "quarter of the clock")
      ->check(CLI::Range(lowest_baud, highest_baud));
  job.add_option("--seed", choices.seed,
                 "seed of everything random: start position, tolerances, noise")
      ->capture_default_str();
  job.add_flag("--warm", choices.warm,
               "the heaters start near their targets, which saves simulated minutes");
  job.add_flag(
      "--every-clock", choices.every_clock,
      "evaluate every clock edge of the chip, with the netlist alone: the same print, many "
      "times slower");
  job.add_option("--processor", choices.processor,
                 "simulate the processor by its model, or by its netlist (slower); both are "
                 "cycle-exact")
      ->transform(CLI::CheckedTransformer(std::map<std::string, sim::Processor>{
          {"model", sim::Processor::model}, {"netlist", sim::Processor::netlist}}))
      ->default_str("model");
  job.add_option("--accept-log", choices.accept_log,
                 "write each line that the firmware accepted: <number or ->TAB<command>")
      ->type_name("FILE");
  job.add_option("--fault", choices.faults,
                 "inject a fault; may be repeated:\n" + std::string(machine::fault_forms()))
      ->type_name("FAULT");
}

}  // namespace command
