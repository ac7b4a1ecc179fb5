// SPDX-License-Identifier: Apache-2.0
// The options of the job `bench`, and what its help says.
#include <CLI/CLI.hpp>

#include "tools/command/bench_job.hpp"

namespace command {

void add_options(CLI::App& app, BenchOptions& options) {
  CLI::App& job = *app.add_subcommand(
      "bench",
      "Measure, in clocks: how hardware and software make steps, how fast the processor is, "
      "how many lines go through the serial line; and how fast the model of the chip runs here.");
  job.add_option("names", options.names, "stepping, processor, model, link; default: all")
      ->type_name("NAME...")
      ->check(CLI::IsMember({"stepping", "processor", "model", "link"}));
  job.add_option("--json", options.json, "write the figures")->type_name("FILE");
  job.add_option("--report", options.report, "folder for the pages: stepping.html, processor.html")
      ->type_name("DIR")
      ->capture_default_str();
  job.add_option("--print", options.print_file,
                 "the whole print to make with both; default: a short one")
      ->type_name("FILE.gcode")
      ->check(CLI::ExistingFile);
  job.add_option("--tolerance-us", options.tolerance_us,
                 "stepping: a tick is punctual up to so long after its exact instant")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  job.add_flag("--quick", options.quick, "few and short runs, to see that everything works");
}

}  // namespace command
