// SPDX-License-Identifier: Apache-2.0
// The options of the job `load`, and what its help says.
#include "tools/command/load_job.hpp"
#include "tools/command/printer_options.hpp"

namespace command {

void add_options(CLI::App& app, LoadOptions& options) {
  CLI::App& job = *app.add_subcommand("load", "Load a program into a chip over its serial line.");
  job.add_option("program", options.program, "ELF file, or the plain contents of the memory")
      ->required()
      ->type_name("FILE");
  job.add_option("port", options.port, "the serial port, or the pseudo-terminal of `serve`")
      ->required()
      ->type_name("PORT");
  job.add_option("--baud", options.baud, "speed of the line")
      ->check(CLI::Range(lowest_baud, highest_baud))
      ->capture_default_str();
  job.footer(
      R"(The running firmware is asked with M997; where it does not answer, reset the board: the
boot loader listens for 10 ms after a reset. Exit status: 0 the chip has checked the program and
starts it, 1 not, and then it starts none, 2 bad usage or no such program.)");
}

}  // namespace command
