// SPDX-License-Identifier: Apache-2.0
// The options of the job `bench`, and what its help says.
#include <CLI/CLI.hpp>

#include "tools/command/bench_job.hpp"

namespace command {

void add_options(CLI::App& app, BenchOptions& options) {
  CLI::App& job = *app.add_subcommand(
      "bench",
      "Measure in clocks: stepping in hardware and software, the processor, the throughput of the "
      "serial line; and on this machine the speed of the simulation and of uploads.");
  job.add_option("names", options.names,
                 "stepping, processor, model, lines, link, upload; default: all")
      ->type_name("NAME...")
      ->check(CLI::IsMember({"stepping", "processor", "model", "lines", "link", "upload"}));
  job.add_option("--json", options.json, "write the figures")->type_name("FILE");
  job.add_option("--report", options.report, "folder for the pages: stepping.html, processor.html")
      ->type_name("DIR")
      ->capture_default_str();
  job.add_option("--print", options.print_file, "the print to make with both; default: a short one")
      ->type_name("FILE.gcode")
      ->check(CLI::ExistingFile);
  job.add_option("--tolerance-us", options.tolerance_us,
                 "stepping: a tick is punctual up to this long after its exact instant")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  job.add_option("--work", options.works,
                 "processor: only core, record, parser or planner; may be repeated; default: all")
      ->type_name("NAME");
  job.add_flag("--profile", options.profile,
               "model: measure where the simulation's time goes, and what ends its leaps");
  job.add_flag("--quick", options.quick, "few and short runs, as a smoke test");
}

}  // namespace command
