// SPDX-License-Identifier: Apache-2.0
// The boards, synthesised by the real tools, take what the pages show, and fit.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "directories.hpp"
#include "tools/synthesis/job.hpp"

namespace synthesis {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const fs::path project = PROJECT_DIRECTORY;
const fs::path output = fs::path(BUILD_DIRECTORY) / "board_synthesis";

json json_of(const fs::path& file) {
  std::ifstream stream(file);
  return json::parse(stream);
}

bool run(Options options) {
  fs::remove_all(options.directory);
  options.zbb = false;
  return synthesize(options, project, fs::path(BUILD_DIRECTORY) / "firmware/firmware.elf");
}

// A change of the hardware moves the figures a little before they are measured again; more than a
// few percent is a change that a person should see.
void expect_figure(const json& figures, const char* name, int found) {
  const double shown = figures.at("values").at(name);
  EXPECT_NEAR(found, shown, 0.03 * shown + 1) << name << ": measure it again (stepfabric figures)";
}

void expect_cyclone(const std::string& board) {
  const json result = json_of(output / board / "synthesis.json"),
             figures = json_of(project / "tools/figures/figures.json").at(board);
  for (const char* name : {"logic_elements", "registers", "block_rams", "multipliers"}) {
    expect_figure(figures, name, result.at(name).at("used"));
  }
}

// synthesize_board has synthesised it, now or when its sources last changed.
TEST(BoardSynthesis, of_the_de2_115_takes_what_the_pages_show) { expect_cyclone("de2_115"); }

TEST(BoardSynthesis, of_the_de2_70_takes_what_the_pages_show) {
  Options options;
  options.board = "de2_70";
  options.directory = output / options.board;
  EXPECT_TRUE(run(options)) << "it does not fit";
  expect_cyclone(options.board);
}

TEST(BoardSynthesis, of_all_boards_makes_one_table) {
  Options options;
  options.all = true;
  options.device = "25k";
  options.directory = output / "all";
  // The core alone is asked for 80 MHz, which not every seed reaches.
  run(options);
  const json rows = json_of(options.directory / "boards.json");
  ASSERT_EQ(rows.size(), 4u);
  const json figures = json_of(project / "tools/figures/figures.json").at("chip");
  expect_figure(figures, "logic_cells", rows.at(0).at("logic").at("used"));
  expect_figure(figures, "registers", rows.at(0).at("registers"));
  EXPECT_GE(rows.at(0).at("fastest_mhz"), 50);
  EXPECT_TRUE(fs::exists(options.directory / "ulx3s/ulx3s.bit"));
}

}  // namespace
}  // namespace synthesis
