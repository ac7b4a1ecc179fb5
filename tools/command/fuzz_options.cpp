// SPDX-License-Identifier: Apache-2.0
// The options of the job `fuzz`, and what its help says.
#include <CLI/CLI.hpp>

#include "tools/command/fuzz_job.hpp"

namespace command {

void add_options(CLI::App& app, FuzzOptions& options) {
  CLI::App& job = *app.add_subcommand(
      "fuzz",
      "Run the fuzz targets (tests/fuzz) for long; `test fuzz` runs each for some seconds.");
  job.add_option("targets", options.targets, "boot_loader, firmware, host_link, ...; default: all")
      ->type_name("TARGET...");
  job.add_option("--executions", options.executions, "inputs of each target")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  job.add_option("--seed", options.seed, "of the mutations; 0: another one each time")
      ->capture_default_str();
  job.add_flag("--minimise", options.minimise,
               "then keep in tests/fuzz/corpus the fewest inputs that go wherever all go");
  job.footer(
      R"(New inputs are kept in <build>/fuzz/corpus/TARGET, from where the next run goes on; one
that violates a property in <build>/fuzz/findings. Exit status: 0 none does, 1 one does,
2 bad usage.)");
}

}  // namespace command
