// SPDX-License-Identifier: Apache-2.0
// The options of the job `run`, and what its help says.
#include <fmt/format.h>

#include "tools/command/printer_options.hpp"
#include "tools/command/run_job.hpp"

namespace command {

void add_options(CLI::App& app, RunOptions& options) {
  CLI::App& job = *app.add_subcommand("run", "Run a bare-metal RV32IMC program on the chip.");
  job.add_option("program", options.program,
                 fmt::format("linked to 0x80000000, {} KiB; ends by a store to `tohost`",
                             CHIP_MEMORY_BYTES / 1024))
      ->required()
      ->type_name("PROGRAM.elf");
  job.add_option("--max-cycles", options.max_cycles, "give up after this many clocks")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  job.add_option("--clock-hz", options.clock_hz, "clock that the chip reports to the program")
      ->check(CLI::Range(lowest_clock_hz, highest_clock_hz))
      ->capture_default_str();
  job.add_option("--baud", options.baud,
                 "show what the program sends on the serial line at this rate")
      ->check(CLI::Range(lowest_baud, highest_baud));
  job.add_option("--signature", options.signature,
                 "write the words from `begin_signature` to `end_signature` at the program's end, "
                 "for the architecture tests")
      ->type_name("FILE");
  job.add_option("--trace", options.trace, "write all signals of the chip")->type_name("FILE.fst");
  job.footer(
      R"(Exit status: that of the program: 0 if it stored 1 to `tohost`, otherwise the value >> 1;
123 stands for 123 and above (the output has the value). Of this command: 124 nothing was stored
within --max-cycles, 125 bad usage or not such a program, 130 interrupted.)");
}

}  // namespace command
