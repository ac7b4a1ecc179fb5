// SPDX-License-Identifier: Apache-2.0
// `serve`: the printer's serial line on a pseudo-terminal, for host programs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "tools/command/print_job.hpp"

namespace command {

// A slow chip that keeps up with the wall's clock serves a host better than a fast one that does
// not.
inline constexpr std::uint32_t lowest_serve_clock_hz = 2'000'000;

struct ServeOptions {
  std::filesystem::path terminal = "/tmp/stepfabric";
  bool real_time = true;
  bool reset_on_open = false;
  std::filesystem::path report = "report";
  std::filesystem::path edges;
  std::optional<double> until_seconds;
  PrinterChoices printer;
};

// Runs until interrupted. Returns the exit status of the job.
int serve(const ServeOptions& options);

}  // namespace command
