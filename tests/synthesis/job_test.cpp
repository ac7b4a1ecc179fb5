// SPDX-License-Identifier: Apache-2.0
// `synth` makes the netlist once, places it from each seed and keeps the fastest, with scripts that
// stand in for the tools.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "directories.hpp"
#include "synthesis_job.hpp"
#include "tools/files/file_text.hpp"
#include "tools/files/path_lock.hpp"
#include "tools/process/process.hpp"

namespace synthesis {
namespace {

TEST_F(SynthesisJob, keeps_the_fastest_of_the_placements_of_one_netlist) {
  options_.seeds = 3;
  options_.device = "25k";
  EXPECT_TRUE(run());
  EXPECT_EQ(text_of("out/ulx3s.bit"), "seed 2 on 25k\n");
  const auto object = nlohmann::json::parse(text_of("out/synthesis.json"));
  EXPECT_EQ(object.at("fastest_mhz"), 63.5);
  EXPECT_EQ(object.at("device"), "25k");
  EXPECT_EQ(object.at("has_debug"), false);
  ASSERT_EQ(object.at("placements").size(), 3u);
  EXPECT_EQ(object.at("placements").at(2).at("seed"), 3);
  EXPECT_EQ(object.at("placements").at(2).at("fastest_mhz"), 53.0);
  const std::string calls = text_of("calls");
  EXPECT_EQ(std::ranges::count(calls, '\n'), 1);
  EXPECT_EQ(calls.find("has_debug"), std::string::npos);
}

TEST_F(SynthesisJob, places_from_the_seed_that_is_asked_for_and_says_where_that_is_too_slow) {
  options_.seed = 7;
  EXPECT_FALSE(run());
  EXPECT_EQ(text_of("out/ulx3s.bit"), "seed 7 on 85k\n");
  const auto object = nlohmann::json::parse(text_of("out/synthesis.json"));
  EXPECT_EQ(object.at("fastest_mhz"), 57.0);
}

TEST_F(SynthesisJob, puts_new_firmware_into_the_layout_that_is_there) {
  write_script("pack_bitstream.sh", "#!/bin/sh\ncat \"$1\" > \"$4\"\necho \"$2 $3\" >> \"$4\"\n");
  options_.firmware_only = true;
  EXPECT_THROW(run(), std::runtime_error);
  options_.firmware_only = false;
  options_.seeds = 3;
  EXPECT_TRUE(run());
  EXPECT_NE(text_of("calls").find(" ulx3s - "), std::string::npos) << text_of("calls");
  const std::string calls = text_of("calls"), report = text_of("out/synthesis.json");
  options_.firmware_only = true;
  EXPECT_TRUE(run());
  const std::string out = std::filesystem::canonical(folder_ / "out");
  EXPECT_EQ(text_of("out/ulx3s.bit"),
            "layout of seed 2 for firmware.elf\n" + out + "/contents.hex firmware.elf\n");
  EXPECT_EQ(text_of("calls"), calls);
  EXPECT_EQ(text_of("out/synthesis.json"), report);
}

TEST_F(SynthesisJob, takes_the_debug_port_where_the_board_has_one) {
  options_.debug = true;
  options_.seed = 2;
  EXPECT_TRUE(run());
  EXPECT_NE(text_of("calls").find("-ghas_debug=true"), std::string::npos);
  options_.board = "core";
  EXPECT_THROW(run(), std::runtime_error);
}

TEST_F(SynthesisJob, measures_the_core_on_an_ice40_and_nothing_else_there) {
  options_.board = "core";
  options_.device = "hx8k";
  EXPECT_TRUE(run());
  const std::string calls = text_of("calls");
  EXPECT_TRUE(calls.starts_with("ice40 ")) << calls;
  EXPECT_NE(calls.find(" core hx8k "), std::string::npos) << calls;
  EXPECT_NE(calls.find("-gmemory_size_bytes=4096"), std::string::npos) << calls;
  const auto object = nlohmann::json::parse(text_of("out/synthesis.json"));
  EXPECT_EQ(object.at("family"), "iCE40");
  EXPECT_EQ(object.at("memory_bytes"), 4096);
  EXPECT_EQ(object.at("lut4"), 6300);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/core.bit"));
  options_.board = "ulx3s";
  EXPECT_THROW(run(), std::runtime_error);
}

TEST_F(SynthesisJob, makes_the_project_for_quartus_of_a_board_with_a_cyclone) {
  std::filesystem::create_directories(folder_ / "boards/de2_70");
  std::ofstream(folder_ / "boards/de2_70/device.csv") << device_table;
  write_script("write_quartus_project.sh", R"(#!/bin/sh
mkdir -p "$4"
echo "$*" >> "$1/calls"
)");
  write_script("synthesize_cyclone.sh", R"(#!/bin/sh
echo '{"design": {"num_cells_by_type": {"cycloneive_lcell_comb": 30000, "dffeas": 20000,
  "altsyncram": 8, "cyclone_block_ram": 3, "cyclone_multiplier": 5}}}' > "$3/cells.json"
)");
  options_.board = "de2_70";
  options_.debug = true;
  EXPECT_TRUE(run());
  EXPECT_NE(text_of("calls").find(" de2_70 firmware.elf "), std::string::npos);
  EXPECT_NE(text_of("calls").find("-ghas_debug=true"), std::string::npos);
  EXPECT_NE(text_of("calls").find("-gmemory_size_bytes=106496"), std::string::npos);
  const auto object = nlohmann::json::parse(text_of("out/synthesis.json"));
  EXPECT_EQ(object.at("device"), "EP2C70F896C6");
  EXPECT_EQ(object.at("logic_elements").at("used"), 30000);
  EXPECT_EQ(object.at("registers").at("used"), 20000);
  // 104 KiB in blocks of 4 Kbit, and two of these for each of 8 that Yosys counts.
  EXPECT_EQ(object.at("block_rams").at("used"), 208 + 6);
  EXPECT_EQ(object.at("multipliers").at("used"), 5);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/de2_70.bit"));
  write_script("write_mif.sh", "#!/bin/sh\necho \"$1 $2\" > \"$3/bank1_lane1.mif\"\n");
  options_.firmware_only = true;
  EXPECT_THROW(run(), std::runtime_error);
  std::ofstream(folder_ / "out/quartus/make_project.tcl");
  EXPECT_TRUE(run());
  EXPECT_EQ(text_of("out/quartus/bank1_lane1.mif"), "firmware.elf 106496\n");
  options_.firmware_only = false;
  // One that is too large, and one of which nothing is known.
  write_script("synthesize_cyclone.sh", R"(#!/bin/sh
echo '{"design": {"num_cells_by_type": {
  "cycloneive_lcell_comb": 70000, "dffeas": 9}}}' > "$3/cells.json"
)");
  EXPECT_FALSE(run());
  write_script("synthesize_cyclone.sh", "#!/bin/sh\necho '{}' > \"$3/cells.json\"\n");
  EXPECT_THROW(run(), std::runtime_error);
}

TEST_F(SynthesisJob, takes_all_boards_into_folders_and_makes_one_table) {
  for (const char* board : {"de2_115", "de2_70"}) {
    std::filesystem::create_directories(folder_ / "boards" / board);
    std::ofstream(folder_ / "boards" / board / "device.csv") << device_table;
  }
  write_script("write_quartus_project.sh", "#!/bin/sh\nmkdir -p \"$4\"\n");
  write_script("synthesize_cyclone.sh", cyclone_script);
  options_.board = "";
  options_.all = true;
  options_.seed = 2;
  EXPECT_TRUE(run());
  const auto rows = nlohmann::json::parse(text_of("out/boards.json"));
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows.at(0).at("board"), "ulx3s");
  EXPECT_EQ(rows.at(0).at("fastest_mhz"), 63.5);
  EXPECT_EQ(rows.at(0).at("ram_kbit"), 34 * 18);
  EXPECT_EQ(rows.at(2).at("logic").at("used"), 30000);
  EXPECT_EQ(rows.at(2).at("ram_kbit"), (208 + 6) * 4);
  EXPECT_FALSE(rows.at(2).contains("fastest_mhz"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/core/synthesis.json"));
  // A machine is that of the boards, and the core has none.
  options_.machine = "delta.toml";
  EXPECT_TRUE(run());
  options_.machine.clear();
  // One that does not fit, or is too slow, makes the whole fail, and the others are made.
  options_.seed = 1;
  EXPECT_FALSE(run());
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/ulx3s/ulx3s.bit"));
}

TEST_F(SynthesisJob, takes_other_pins_where_the_board_has_them) {
  std::filesystem::create_directories(folder_ / "boards/de2_70_reprap_2012");
  std::ofstream(folder_ / "boards/de2_70_reprap_2012/device.csv") << device_table;
  write_script("write_quartus_project.sh",
               "#!/bin/sh\nmkdir -p \"$4\"\necho \"$*\" >> \"$1/calls\"\n");
  write_script("synthesize_cyclone.sh", cyclone_script);
  options_.board = "de2_70";
  options_.pins = "reprap_2012";
  EXPECT_TRUE(run());
  EXPECT_NE(text_of("calls").find(" de2_70_reprap_2012 firmware.elf "), std::string::npos);
  options_.board = "de2_115";
  EXPECT_THROW(run(), std::runtime_error);
}

TEST_F(SynthesisJob, fails_where_a_tool_fails) {
  write_script("place_board.sh", "#!/bin/sh\nexit 3\n");
  EXPECT_THROW(run(), std::runtime_error);
}

// The scripts of the project itself, with a tool that says what nextpnr says.
TEST_F(SynthesisJob, says_of_what_a_device_has_too_little) {
  const std::filesystem::path tool = folder_ / "nextpnr";
  std::ofstream(tool) << R"(#!/bin/sh
echo "Info: Device utilisation:"
echo "Info: 	         ICESTORM_LC:  9679/ 7680   126%"
echo "Info: 	        ICESTORM_RAM:    32/   32   100%"
echo "ERROR: Unable to place cell 'x', no BELs remaining to implement cell type 'ICESTORM_LC'"
exit 1
)";
  std::filesystem::permissions(tool, std::filesystem::perms::owner_all);
  const auto [status, words] =
      process::capture({.arguments = {"sh", "-c",
                                      "directory=. && . '" PROJECT_DIRECTORY
                                      "/tools/hardware/steps.sh' && place ./nextpnr"},
                        .folder = folder_});
  EXPECT_NE(status, 0);
  EXPECT_NE(words.find("does not fit into this device"), std::string::npos) << words;
  EXPECT_NE(words.find("ICESTORM_LC:  9679/ 7680   126%"), std::string::npos) << words;
  EXPECT_EQ(words.find("ICESTORM_RAM"), std::string::npos) << words;
}

TEST_F(SynthesisJob, leaves_a_folder_alone_in_which_another_is_at_work) {
  std::filesystem::create_directories(options_.directory);
  {
    const files::PathLock other(std::filesystem::canonical(options_.directory));
    try {
      run();
      FAIL() << "both wrote into one folder";
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find("is in use by process"), std::string::npos);
      EXPECT_NE(std::string(error.what()).find("--directory"), std::string::npos);
    }
    EXPECT_FALSE(std::filesystem::exists(folder_ / "calls"));
  }
  EXPECT_NO_THROW(run());
  EXPECT_TRUE(std::filesystem::exists(folder_ / "calls"));
}

}  // namespace
}  // namespace synthesis
