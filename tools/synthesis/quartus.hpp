// SPDX-License-Identifier: Apache-2.0
// `synth` for a board with a Cyclone: the project for Quartus, and what the chip takes as Yosys
// counts it. Only Quartus makes the bitstream.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>

namespace synthesis {

struct Options;

bool has_cyclone(const std::filesystem::path& project, const std::string& board);

// Of its device.csv.
std::map<std::string, std::string> board_properties(const std::filesystem::path& board_folder);

// What the device has and what the chip takes of it, in cells of a Cyclone IV E.
struct CycloneReport {
  std::string board, family, device, quartus;
  bool has_debug = false;
  std::uint32_t memory_bytes = 0;
  int logic_elements = 0, logic_elements_there = 0;
  int registers = 0;
  // Blocks as large as the device's.
  int block_rams = 0, block_rams_there = 0;
  int multipliers = 0, multipliers_there = 0;

  bool fits() const {
    return logic_elements <= logic_elements_there && block_rams <= block_rams_there &&
           multipliers <= multipliers_there;
  }
};

// Reads `cells.json` (yosys stat -json) and the board's device.csv. Throws std::runtime_error where
// something is missing.
CycloneReport read_cyclone_report(const std::filesystem::path& cells,
                                  const std::filesystem::path& board_folder,
                                  std::uint32_t memory_bytes);
std::string as_json(const CycloneReport& report);
std::string as_table(const CycloneReport& report);

// Writes the project into directory/quartus and synthesis.json into the directory. False where the
// chip does not fit. Throws std::runtime_error where a tool fails.
bool make_quartus_project(const Options& options, const std::filesystem::path& project,
                          const std::filesystem::path& firmware,
                          const std::filesystem::path& directory,
                          const std::function<void()>& look);

}  // namespace synthesis
