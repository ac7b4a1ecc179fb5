// SPDX-License-Identifier: Apache-2.0
// The options of the job `fuzz`, and what its help says.
#include <CLI/CLI.hpp>

#include "tools/command/fuzz_job.hpp"

namespace command {

void add_options(CLI::App& app, FuzzOptions& options) {
  CLI::App& job = *app.add_subcommand(
      "fuzz",
      "Run the fuzz targets (tests/fuzz) for a long time; `test fuzz` runs each for seconds.");
  job.add_option("targets", options.targets, "boot_loader, firmware, host_link, ...; default: all")
      ->type_name("TARGET...");
  job.add_option("--executions", options.executions, "inputs of each target")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  job.add_option("--seed", options.seed, "seed of the mutations; 0: random")->capture_default_str();
  job.add_flag("--minimise", options.minimise,
               "then reduce tests/fuzz/corpus to the fewest inputs with the same coverage");
  job.footer(
      R"(New inputs are kept in <build>/fuzz/corpus/TARGET, where the next run continues; inputs
that violate a property in <build>/fuzz/findings. Exit status: 0 no violation, 1 a violation,
2 bad usage.)");
}

}  // namespace command
