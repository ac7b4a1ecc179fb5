// SPDX-License-Identifier: Apache-2.0
// `synth --all`: every board, one after the other, and one table of what each takes.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace synthesis {

struct Options;

// A board's row, out of its synthesis.json.
struct BoardFigures {
  std::string board, device;
  int logic = 0, logic_there = 0;  // logic cells or elements
  int registers = 0;
  int ram_kbit = 0;  // of the blocks that are used
  int multipliers = 0;
  double fastest_mhz = 0;  // 0 where no open tool places
};

// Throws std::runtime_error where something is missing.
BoardFigures read_board_figures(const std::filesystem::path& synthesis_json);
std::string as_table(const std::vector<BoardFigures>& boards);

// Each board into a folder of its name; `boards.json` has all rows. False where one is too slow or
// does not fit. Throws std::runtime_error where a tool fails.
bool synthesize_all(const Options& options, const std::filesystem::path& project,
                    const std::filesystem::path& firmware, const std::function<void()>& look);

}  // namespace synthesis
