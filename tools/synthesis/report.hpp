// SPDX-License-Identifier: Apache-2.0
// Cells and clock speed of a synthesis, from the reports of Yosys and nextpnr.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/synthesis/device.hpp"

namespace synthesis {

// A kind of cell: how many are used of those that the device has.
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

// How fast the chip became when placed from one seed.
struct Placement {
  std::uint32_t seed = 0;
  double fastest_mhz = 0;
};

// What lies between the pins and the registers next to them. nextpnr counts it from pad to
// register, without the buffer in the pad.
struct PinTimes {
  // Outputs whose register lies in the pad.
  int pad_registers = 0;
  double input_to_register_ns = 0;
  double register_to_output_ns = 0;
};

struct Report {
  std::string board;
  std::string device;
  Family family = Family::ecp5;
  bool has_debug = false;
  std::uint32_t memory_bytes = 0;
  // All that were tried; the figures below are those of the fastest.
  std::vector<Placement> placements;
  // Look-up tables of four inputs before packing, without those in an ECP5's carry chains. An
  // iCE40's chains have none of their own: those of its sums are counted.
  int lut4 = 0;
  Usage logic_cells;
  Usage registers;
  // Of 18 kbit on an ECP5, of 4 on an iCE40.
  Usage block_rams;
  Usage multipliers;
  // Of the fastest of the design's clocks.
  double wanted_mhz = 0;
  double fastest_mhz = 0;
  std::vector<Hop> critical_path;
  PinTimes pins;
  // So many registers, and no longer times. Of a board only.
  std::optional<PinTimes> wanted_pins;

  // Of all clocks, those that are slower than they must be.
  std::vector<std::string> slow_clocks;

  bool fast_enough() const { return fastest_mhz >= wanted_mhz && slow_clocks.empty(); }
  bool pins_are_good() const;
  // How much faster than wanted the clock could be, in percent.
  double margin_percent() const { return (fastest_mhz / wanted_mhz - 1) * 100; }
};

// Reads `cells.json` (yosys stat -json) in the netlist's folder and `report.json` (nextpnr
// --report) and, of a board, `pins.json` (place_board.sh) in the layout's. Throws
// std::runtime_error where something is missing.
Report read_report(const std::filesystem::path& netlist, const std::filesystem::path& layout,
                   Family family);
// Of the chip that a synthesis.json speaks of, in bytes; nothing where there is no such file.
std::optional<std::uint32_t> memory_of(const std::filesystem::path& synthesis_json);
std::string as_json(const Report& report);
// A few lines for people.
std::string as_table(const Report& report);

}  // namespace synthesis
