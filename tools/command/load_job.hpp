// SPDX-License-Identifier: Apache-2.0
// `load`: a program into a chip, over its serial line.
#pragma once

#include <cstdint>
#include <filesystem>

namespace CLI {
class App;
}

namespace command {

struct LoadOptions {
  std::filesystem::path program;
  std::filesystem::path port;
  std::uint32_t baud = 250'000;
};

// Adds the job to the program.
void add_options(CLI::App& app, LoadOptions& options);

// Returns the exit status of the job.
int load(const LoadOptions& options);

}  // namespace command
