// SPDX-License-Identifier: Apache-2.0
// `timing`: bounds of the execution times of the firmware's functions.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace command {

struct TimingOptions {
  std::vector<std::string> functions;  // empty: all
  bool json = false;
  std::filesystem::path tasks;  // the print in which they are measured; empty: none
  bool schedule = false;
  double seconds = 20;  // of that print
  std::uint64_t inputs = 0;  // to be searched for bad ones; 0: no search
  std::uint64_t seed = 1;
  std::filesystem::path state;  // file of a search that goes on; empty: none
};

// Adds the job to the program.
void add_options(CLI::App& app, TimingOptions& options);

// Returns the exit status of the job.
int timing_of(const TimingOptions& options);

}  // namespace command
