// SPDX-License-Identifier: Apache-2.0
// Prints with and without `--every-clock`: the same edges, lines and report, byte for byte.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include "directories.hpp"
#include "tests/scenarios/job.hpp"
#include "tools/files/file_text.hpp"

namespace {

using Options = std::vector<std::string>;

const std::string examples = PROJECT_DIRECTORY "/examples/";

std::vector<std::string> lines_of(const std::string& file) {
  std::ifstream stream(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

// Each byte that a job leaves, but for how long it took; and its exit status.
auto left_by(const std::string& file, Options options) {
  const auto accepted = scenarios::scratch_folder() / "accepted";
  options.insert(options.end(), {"--accept-log", accepted.string()});
  const scenarios::Print print = scenarios::print_file(file, options);
  nlohmann::json report = print.report;
  EXPECT_GT(report.erase("wall_seconds"), 0u) << print.job.output;
  return std::tuple(print.job.status, files::text_of(print.edges), files::text_of(accepted),
                    report.dump());
}

// Returns the edges.
std::string expect_same(const std::string& file, const Options& options) {
  Options slow = options;
  slow.push_back("--every-clock");
  const auto quick = left_by(file, options);
  // One by one, since megabytes would be printed otherwise.
  const auto whole = left_by(file, slow);
  EXPECT_EQ(std::get<0>(whole), std::get<0>(quick));
  EXPECT_TRUE(std::get<1>(whole) == std::get<1>(quick)) << "the edges differ";
  EXPECT_TRUE(std::get<2>(whole) == std::get<2>(quick)) << "the accepted lines differ";
  EXPECT_TRUE(std::get<3>(whole) == std::get<3>(quick)) << "the reports differ";
  return std::get<1>(quick);
}

std::size_t count_lines(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count(text, '\n'));
}

// --- Each time another part of another file, with another noise.

constexpr std::array example_names{"washer.gcode", "cube20_02_marlin.gcode",
                                   "endstop_bracket_02_marlin.gcode"};
constexpr std::size_t part_lines = 40;

// The hotend is hot, and the printer is assumed to be where the part begins.
std::string part_of(const std::vector<std::string>& lines, std::size_t first) {
  std::string text = "M104 S205\nG92 X50 Y50 Z0.2 E0\nG1 F3000\n";
  for (std::size_t i = first; i < first + part_lines; ++i) {
    const bool moves = lines[i].starts_with("G1 ") || lines[i].starts_with("G92 ");
    if (moves) text += lines[i] + "\n";
  }
  return text;
}

TEST(every_clock, of_a_random_part_of_a_print_is_the_same) {
  const auto seed = std::random_device()();
  std::mt19937 random(seed);
  const std::string name = example_names[random() % example_names.size()];
  const std::vector<std::string> lines = lines_of(examples + name);
  ASSERT_GT(lines.size(), 2 * part_lines);
  const std::size_t first = random() % (lines.size() - part_lines);
  SCOPED_TRACE(
      fmt::format("lines {} to {} of {}, --seed {}", first + 1, first + part_lines, name, seed));
  const auto file = scenarios::scratch_folder() / "part.gcode";
  scenarios::write_file(file, part_of(lines, first));
  expect_same(file.string(), {"--warm", "--until", "2.5", "--fault", "serial=0.005", "--seed",
                              std::to_string(seed)});
}

// --- Each night: hours on one core.

class EveryClockOfFile : public testing::TestWithParam<const char*> {};

TEST_P(EveryClockOfFile, is_the_same) {
  EXPECT_GT(count_lines(expect_same(examples + GetParam() + ".gcode", {"--warm"})), 100'000u);
}

INSTANTIATE_TEST_SUITE_P(nightly, EveryClockOfFile,
                         testing::Values("washer", "cube20_02_marlin", "endstop_bracket_02_marlin"),
                         [](const auto& name) { return std::string(name.param); });

TEST(every_clock, of_the_washer_at_50_mhz_is_the_same) {
  const std::string edges =
      expect_same(examples + "washer.gcode", {"--warm", "--clock-hz", "50000000", "--until", "15"});
  EXPECT_GT(count_lines(edges), 1000u);
}

class EveryClockWithFaults : public testing::TestWithParam<int> {};

// With noise on the line, and one fault that is another for each seed.
TEST_P(EveryClockWithFaults, is_the_same) {
  constexpr std::array faults{"x-end-stop-bounces",     "y-end-stop-never-closes",
                              "hotend-open@9",          "hotend-heater-stuck-on@6",
                              "hotend-capacitor=0.5@7", "bed-short@8",
                              "cable-pulled=0.7@9",     "replies=0.01",
                              "hotend-stuck-high@10",   "bed-capacitor-lost@5"};
  const int seed = GetParam();
  expect_same(examples + "washer.gcode",
              {"--warm", "--until", "25", "--seed", std::to_string(seed), "--fault", "serial=0.002",
               "--fault", faults[static_cast<std::size_t>(seed - 1)]});
}

INSTANTIATE_TEST_SUITE_P(nightly, EveryClockWithFaults, testing::Range(1, 11),
                         [](const auto& seed) { return fmt::format("seed_{}", seed.param); });

}  // namespace
