// SPDX-License-Identifier: Apache-2.0
// A board prints what the bare chip prints.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdint>
#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "directories.hpp"
#include "tools/process/process.hpp"

namespace {

namespace fs = std::filesystem;

const fs::path project = PROJECT_DIRECTORY;
// Every board's model has this clock (sim/CMakeLists.txt).
constexpr const char* clock_hz = "4000000";
// One clock for the registers before the pins. Each hit of an end stop comes later by it, and the
// firmware may go on a clock later after it: two hits in the homing of each of three axes.
constexpr std::int64_t most_clocks_later = 1 + 2 * 3;

struct Edge {
  std::int64_t cycle{};
  std::string rest;  // axis, direction, position
};

std::vector<Edge> edges_of(const fs::path& file) {
  std::ifstream stream(file);
  std::vector<Edge> edges;
  std::string line;
  std::getline(stream, line);
  EXPECT_EQ(line, "cycle,axis,direction,position");
  while (std::getline(stream, line)) {
    const std::size_t comma = line.find(',');
    edges.push_back({std::stoll(line.substr(0, comma)), line.substr(comma)});
  }
  return edges;
}

std::vector<Edge> printed(const fs::path& gcode, const std::string& board, bool warm) {
  // The tests of the boards run at once, and each prints on the bare chip too: no two may share it.
  const fs::path folder =
      fs::path(testing::TempDir()) / ("stepfabric virtual board " + std::to_string(getpid()));
  fs::remove_all(folder);
  fs::create_directories(folder);
  std::vector<std::string> words{
      (fs::path(BUILD_DIRECTORY) / "bin" / (board.empty() ? "stepfabric" : "stepfabric_" + board))
          .string(),
      "print",
      gcode.string(),
      "--clock-hz",
      clock_hz,
      "--report",
      folder / "report",
      "--edges",
      folder / "edges.csv"};
  if (!board.empty()) words.insert(words.end(), {"--board", board});
  if (warm) words.emplace_back("--warm");
  const auto [status, text] = process::capture({.arguments = words, .folder = folder});
  EXPECT_EQ(status, 0) << text;
  std::vector<Edge> edges = edges_of(folder / "edges.csv");
  fs::remove_all(folder);
  return edges;
}

// Once for all the boards that one process tests.
const std::vector<Edge>& printed_by_the_bare_chip(const fs::path& gcode, bool warm) {
  static std::map<std::pair<fs::path, bool>, std::vector<Edge>> edges;
  const auto [place, is_new] = edges.try_emplace({gcode, warm});
  if (is_new) place->second = printed(gcode, "", warm);
  return place->second;
}

void expect_the_same_print(const fs::path& gcode, const std::string& board, bool warm) {
  const std::vector<Edge>& bare = printed_by_the_bare_chip(gcode, warm);
  const std::vector<Edge> found = printed(gcode, board, warm);
  ASSERT_GT(bare.size(), 10'000u);
  ASSERT_EQ(found.size(), bare.size());
  for (std::size_t i = 0; i < bare.size(); ++i) {
    ASSERT_EQ(found[i].rest, bare[i].rest) << "edge " << i;
    const std::int64_t later = found[i].cycle - bare[i].cycle;
    ASSERT_GE(later, 1) << "edge " << i;
    ASSERT_LE(later, most_clocks_later) << "edge " << i;
  }
}

class VirtualBoard : public testing::TestWithParam<std::string> {};

TEST_P(VirtualBoard, makes_the_edges_of_the_bare_chip) {
  expect_the_same_print(project / "tools/benchmark/short_print.gcode", GetParam(), false);
}

TEST_P(VirtualBoard, prints_the_washer_as_the_bare_chip_does) {
  expect_the_same_print(project / "examples/washer.gcode", GetParam(), true);
}

INSTANTIATE_TEST_SUITE_P(boards, VirtualBoard,
                         testing::Values("de2_115", "de2_70", "de2_70_reprap_2012", "ulx3s"),
                         [](const auto& test) { return test.param; });

}  // namespace
