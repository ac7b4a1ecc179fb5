// SPDX-License-Identifier: Apache-2.0
// `synth`: the chip with its firmware for a board, up to the bitstream, and what it costs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

namespace CLI {
class App;
}

namespace synthesis {

struct Options {
  std::string board;
  // Every board, in the place of one.
  bool all = false;
  // Of a board with more than one wiring: boards/BOARD_PINS.
  std::string pins;
  std::string device = "85k";
  std::uint32_t seed = 1;
  std::uint32_t seeds = 1;
  // Whose firmware it is; none: the machine of the build.
  std::filesystem::path machine;
  // Of the chip's memory, where it is not the processor alone.
  std::uint32_t memory_bytes = CHIP_MEMORY_BYTES;
  bool debug = false;
  bool zbb = STEPFABRIC_ZBB;
  // The layout that the directory has from before, with the firmware of now.
  bool firmware_only = false;
  std::filesystem::path directory = "synthesis";
};

void add_options(CLI::App& job, Options& options);

// All boards or one. `firmware` is the ELF file that becomes the memory's contents. Writes the
// netlist, BOARD.bit, layout.config and synthesis.json of the fastest placement, and a folder for
// each placement, into the directory.
// False where the clock or a pin is too slow for the board's. Throws std::runtime_error where a
// tool fails, or where the memory does not fit into the device. `look` is called every few
// milliseconds; where it throws, the tools end.
bool synthesize(const Options& options, const std::filesystem::path& project,
                const std::filesystem::path& firmware, const std::function<void()>& look = {});

}  // namespace synthesis
