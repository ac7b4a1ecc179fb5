// SPDX-License-Identifier: Apache-2.0
// `fuzz`: long runs of the fuzz targets (tests/fuzz).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace command {

struct FuzzOptions {
  std::vector<std::string> targets;  // none: all
  std::uint64_t executions = 1'000'000;  // of each
  std::uint32_t seed = 0;  // 0: another one each time
  bool minimise = false;
};

// Adds the job to the program.
void add_options(CLI::App& app, FuzzOptions& options);

// Returns the exit status of the job.
int fuzz(const FuzzOptions& options);

}  // namespace command
