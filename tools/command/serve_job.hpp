// SPDX-License-Identifier: Apache-2.0
// `serve`: the printer's serial line on a pseudo-terminal, for host programs.
#pragma once

#include <filesystem>

#include "tools/command/print_job.hpp"

namespace command {

struct ServeOptions {
  std::filesystem::path terminal = "/tmp/stepfabric";
  bool real_time = false;
  PrinterChoices printer;
};

// Runs until interrupted. Returns the exit status of the job.
int serve(const ServeOptions& options);

}  // namespace command
