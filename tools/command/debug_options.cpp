// SPDX-License-Identifier: Apache-2.0
// The options of the job `debug`, and what its help says.
#include "tools/command/clock_choice.hpp"
#include "tools/command/debug_job.hpp"
#include "tools/command/printer_options.hpp"

namespace command {

void add_options(CLI::App& app, DebugOptions& options) {
  CLI::App& job = *app.add_subcommand(
      "debug", "Run the chip with its JTAG pins open to OpenOCD and gdb, until Ctrl-C.");
  job.add_option("program", options.program,
                 "as for `run`; default: the firmware, on the simulated printer")
      ->type_name("PROGRAM.elf");
  job.add_option("--port", options.port, "TCP port for OpenOCD's remote_bitbang; 0: any free one")
      ->capture_default_str();
  job.add_option("--pty", options.terminal, "symlink to the firmware's serial line, for a host")
      ->type_name("PATH");
  job.add_option("--until", options.until_seconds, "stop after this many simulated seconds")
      ->type_name("S")
      ->check(CLI::PositiveNumber);
  job.add_option("--clock-hz", options.printer.clock_hz, "clock of the chip")
      ->check(CLI::Range(lowest_serve_clock_hz, highest_clock_hz))
      ->capture_default_str();
  add_printer_options(job, options.printer);
  job.footer(
      R"(Prints how to connect OpenOCD and gdb (tools/debug). While the processor is halted the rest
of the chip runs on: the watchdog switches the heaters off, as for software that hangs.
Exit status: 0 after Ctrl-C or --until, 1 a hardware assertion failed, 2 bad usage.)");
}

}  // namespace command
