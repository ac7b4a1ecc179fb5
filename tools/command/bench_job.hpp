// SPDX-License-Identifier: Apache-2.0
// `bench`: the benchmarks, in clocks of the chip.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/benchmark/lateness.hpp"

namespace CLI {
class App;
}

namespace command {

struct BenchOptions {
  std::vector<std::string> names;  // none: all
  std::filesystem::path json;
  std::filesystem::path report = "report";
  std::filesystem::path print_file;
  double tolerance_us = benchmarks::default_tolerance_us;  // of punctual ticks
  bool quick = false;
  bool profile = false;  // of the model
  std::vector<std::string> works;  // of the processor; none: all
};

// Adds the job to the program.
void add_options(CLI::App& app, BenchOptions& options);

// Returns the exit status of the job.
int bench(const BenchOptions& options);

}  // namespace command
