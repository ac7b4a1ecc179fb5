// SPDX-License-Identifier: Apache-2.0
// The options of the job `load`, and what its help says.
#include "tools/command/load_job.hpp"
#include "tools/command/printer_options.hpp"

namespace command {

void add_options(CLI::App& app, LoadOptions& options) {
  CLI::App& job = *app.add_subcommand("load", "Load a program into a chip over its serial line.");
  job.add_option("program", options.program, "ELF file, or a raw memory image")
      ->required()
      ->type_name("FILE");
  job.add_option("port", options.port, "the serial port, or the pseudo-terminal of `serve`")
      ->required()
      ->type_name("PORT");
  job.add_option("--baud", options.baud, "baud rate of the line")
      ->check(CLI::Range(lowest_baud, highest_baud))
      ->capture_default_str();
  job.footer(
      R"(The running firmware gets M997; if it does not answer, reset the board: the boot loader
listens for 10 ms after a reset. Exit status: 0 the chip has checked the program and starts it,
1 the transfer or the check failed and nothing is started, 2 bad usage or not such a program.)");
}

}  // namespace command
