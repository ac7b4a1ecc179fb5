// SPDX-License-Identifier: Apache-2.0
// `serve`: the printer's serial line on a pseudo-terminal, for host programs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "tools/command/clock_choice.hpp"
#include "tools/command/print_job.hpp"

namespace CLI {
class App;
}

namespace command {

struct ServeOptions {
  std::filesystem::path terminal;  // empty: `port` in the user's private folder
  bool real_time = true;
  bool reset_on_open = false;
  std::filesystem::path report = "report";
  std::filesystem::path edges;
  std::optional<double> until_seconds;
  // Of the chip. If empty: one at which this machine keeps up with real time, or that of `printer`
  // where this is not needed.
  std::optional<std::uint32_t> clock_hz;
  PrinterChoices printer;
};

// Adds the job to the program.
void add_options(CLI::App& app, ServeOptions& options);

// Runs until interrupted. Returns the exit status of the job.
int serve(ServeOptions options);

}  // namespace command
