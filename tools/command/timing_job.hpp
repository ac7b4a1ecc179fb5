// SPDX-License-Identifier: Apache-2.0
// `timing`: bounds of the execution times of the firmware's functions.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace command {

struct TimingOptions {
  std::vector<std::string> functions;  // empty: all
  bool json = false;
};

// Adds the job to the program.
void add_options(CLI::App& app, TimingOptions& options);

// Returns the exit status of the job.
int timing_of(const TimingOptions& options);

}  // namespace command
