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

// Of a DE2-70 and of a DE2-115.
inline constexpr const char* device_table = R"(property,value
family,Cyclone II
device,EP2C70F896C6
quartus,13.0sp1
logic_elements,68416
block_rams,250
block_ram_bits,4096
multipliers,150
)";
inline constexpr const char* large_device_table = R"(property,value
family,Cyclone IV E
device,EP4CE115F29C7
quartus,13.0sp1 to 20.1
logic_elements,114480
block_rams,432
block_ram_bits,8192
multipliers,266
)";

// What Yosys counts of a Cyclone's cells.
inline constexpr const char* cyclone_script = R"(#!/bin/sh
echo '{"design": {"num_cells_by_type": {"cycloneive_lcell_comb": 30000, "dffeas": 20000,
  "cyclone_block_ram": 3, "cyclone_multiplier": 5}}}' > "$3/cells.json"
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

  void take_boards_with_a_cyclone() const {
    for (const char* board : {"de2_115", "de2_70", "de2_70_reprap_2012"}) {
      std::filesystem::create_directories(folder_ / "boards" / board);
      std::ofstream(folder_ / "boards" / board / "device.csv")
          << (board == std::string("de2_115") ? large_device_table : device_table);
    }
    write_script("write_quartus_project.sh",
                 "#!/bin/sh\nmkdir -p \"$4\"\necho \"$*\" >> \"$1/calls\"\n");
    write_script("synthesize_cyclone.sh", cyclone_script);
  }

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
