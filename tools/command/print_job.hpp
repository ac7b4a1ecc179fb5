// SPDX-License-Identifier: Apache-2.0
// `print`: a G-code file on the simulated printer, with a report.
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "sim/simulation/edges.hpp"

namespace CLI {
class App;
}

namespace command {

struct PrinterChoices {
  std::filesystem::path machine;
  std::uint32_t clock_hz = 4'000'000;
  std::optional<std::uint32_t> baud;
  std::uint64_t seed = 1;
  bool warm = false;
  bool every_clock = false;  // no leaps, no edges left out, and the processor by its netlist
  sim::Processor processor = sim::Processor::model;
  std::string stepping = "hardware";
  std::vector<std::string> faults;
  std::filesystem::path accept_log;
};

// The netlist of the whole chip replays intervals of the print.
struct ReplayChoices {
  bool asked = false;
  std::optional<std::size_t> count;  // so many at random; all where there is none
  std::optional<std::uint64_t> seed;  // of the choice; any where there is none
  std::size_t first = 1, last = std::numeric_limits<std::size_t>::max();  // no others
  bool every_clock = false;
};

struct PrintOptions {
  std::filesystem::path file;
  std::size_t window = 1;  // lines in flight
  bool no_answer = false;  // to M0 and M1
  std::filesystem::path report = "report";
  std::filesystem::path edges;
  std::filesystem::path trace;
  std::string board;  // whose top entity is around the chip; empty: none is
  std::optional<double> until_seconds;
  ReplayChoices replay;
  PrinterChoices printer;
};

// Adds the job to the program.
void add_options(CLI::App& app, PrintOptions& options);

// Returns the exit status of the job.
int print(const PrintOptions& options);

}  // namespace command
