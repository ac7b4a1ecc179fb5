// SPDX-License-Identifier: Apache-2.0
// What a synthesis costs and how fast the result is, out of what Yosys and nextpnr have written.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace synthesis {

// A kind of cell: how many of how many the device has.
struct Usage {
  int used = 0;
  int available = 0;
};

// One hop of the slowest path, from the output of a cell to the input of the next.
struct Hop {
  std::string from;
  std::string to;
  double delay_ns = 0;
};

struct Report {
  std::string board;
  std::string device;
  // Look-up tables of four inputs before packing, without those in carry chains.
  int lut4 = 0;
  Usage logic_cells;
  Usage registers;
  Usage block_rams;
  Usage multipliers;
  double wanted_mhz = 0;
  double fastest_mhz = 0;
  std::vector<Hop> critical_path;

  bool fast_enough() const { return fastest_mhz >= wanted_mhz; }
  // How much faster than wanted the clock could be, in percent.
  double margin_percent() const { return (fastest_mhz / wanted_mhz - 1) * 100; }
};

// Reads `cells.json` (yosys stat -json) and `report.json` (nextpnr --report) in the folder.
// Throws std::runtime_error where something is missing.
Report read_report(const std::filesystem::path& folder);
std::string as_json(const Report& report);
// A few lines for people.
std::string as_table(const Report& report);

}  // namespace synthesis
