// SPDX-License-Identifier: Apache-2.0
// `synth` with scripts that stand in for the tools.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "tools/files/file_text.hpp"
#include "tools/synthesis/job.hpp"

namespace synthesis {

// Writes the arguments down, one call a line.
inline constexpr const char* synthesize_script = R"(#!/bin/sh
echo "$*" >> "$1/calls"
echo '{"design": {"num_cells_by_type": {"LUT4": 7000}}}' > "$4/cells.json"
)";

// Seed 2 gives the fastest clock.
inline constexpr const char* place_script = R"(#!/bin/sh
case $5 in 2) mhz=63.5 ;; *) mhz=5$5.0 ;; esac
mkdir -p "$6"
echo "seed $5 on $4" > "$6/$2.bit"
echo "layout of seed $5 for $7" > "$6/layout.config"
cat > "$6/report.json" <<END
{"fmax": {"clk": {"achieved": $mhz, "constraint": 60.0}},
 "utilization": {
   "TRELLIS_COMB": {"available": 80000, "used": 14000},
   "TRELLIS_FF": {"available": 80000, "used": 6000},
   "DP16KD": {"available": 200, "used": 34},
   "MULT18X18D": {"available": 150, "used": 5}},
 "critical_paths": []}
END
)";

inline constexpr const char* synthesize_ice40_script = R"(#!/bin/sh
echo "ice40 $*" >> "$1/calls"
echo '{"design": {"num_cells_by_type": {"SB_LUT4": 6300, "SB_DFFE": 900}}}' > "$4/cells.json"
)";

inline constexpr const char* place_ice40_script = R"(#!/bin/sh
mkdir -p "$6"
cat > "$6/report.json" <<END
{"fmax": {"clk": {"achieved": 52.5, "constraint": 50.0}},
 "utilization": {
   "ICESTORM_LC": {"available": 7680, "used": 6800},
   "ICESTORM_RAM": {"available": 32, "used": 20}},
 "critical_paths": []}
END
)";

class SynthesisJob : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_ / "tools/hardware");
    write_script("synthesize_board.sh", synthesize_script);
    write_script("place_board.sh", place_script);
    write_script("synthesize_ice40.sh", synthesize_ice40_script);
    write_script("place_ice40.sh", place_ice40_script);
    options_.board = "ulx3s";
    options_.directory = folder_ / "out";
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  void write_script(const char* name, const char* text) const {
    const std::filesystem::path file = folder_ / "tools/hardware" / name;
    std::ofstream(file) << text;
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  }
  bool run() const { return synthesize(options_, folder_, "firmware.elf"); }
  std::string text_of(const char* file) const { return files::text_of(folder_ / file); }

  std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) / "stepfabric synthesis job test";
  Options options_;
};

}  // namespace synthesis
