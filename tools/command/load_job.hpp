// SPDX-License-Identifier: Apache-2.0
// `load`: a program into a chip, over its serial line.
#pragma once

#include <cstdint>
#include <filesystem>

namespace command {

struct LoadOptions {
  std::filesystem::path program;
  std::filesystem::path port;
  std::uint32_t baud = 250'000;
};

// Returns the exit status of the job.
int load(const LoadOptions& options);

}  // namespace command
