// SPDX-License-Identifier: Apache-2.0
// `debug`: the chip with its debug port, for OpenOCD and gdb.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "tools/command/print_job.hpp"

namespace CLI {
class App;
}

namespace command {

// Where OpenOCD looks in tools/debug/simulation.cfg by default.
inline constexpr std::uint16_t default_debug_port = 9824;

struct DebugOptions {
  // Empty: the firmware, on the simulated printer.
  std::filesystem::path program;
  // 0: any that is free.
  std::uint16_t port = default_debug_port;
  // With the firmware: a symlink to the printer's serial line; empty for none.
  std::filesystem::path terminal;
  std::optional<double> until_seconds;
  PrinterChoices printer;
};

// Adds the job to the program.
void add_options(CLI::App& app, DebugOptions& options);

// Runs until interrupted, in a program whose model has the debug port. Returns the exit status of
// the job.
int debug(const DebugOptions& options);

}  // namespace command
