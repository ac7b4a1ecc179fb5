// SPDX-License-Identifier: Apache-2.0
// The netlist of the whole chip does parts of a print again, and comes to the same.
#include <gmock/gmock.h>

#include <cstdio>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include "directories.hpp"
#include "tests/scenarios/job.hpp"

namespace {

using scenarios::Print;
using scenarios::print_file;
using scenarios::print_text;

const std::string washer = PROJECT_DIRECTORY "/examples/washer.gcode";

// Of the line that the job says: intervals replayed, and how many there were. Each time others are
// chosen; where one differs, the output says which, and the seed to choose it again.
std::pair<int, int> expect_no_difference(const Print& print) {
  EXPECT_EQ(print.job.status, 0) << print.job.output;
  std::smatch found;
  const std::regex line(R"(replay: (\d+) of (\d+) intervals.*: 0 differ)");
  if (!std::regex_search(print.job.output, found, line)) {
    ADD_FAILURE() << print.job.output;
    return {};
  }
  std::printf("%s\n", found[0].str().c_str());
  EXPECT_EQ(print.job.output.find("could not be recorded"), std::string::npos);
  return {std::stoi(found[1]), std::stoi(found[2])};
}

TEST(replay_prints, intervals_at_random_are_the_same_at_4_mhz) {
  const Print print = print_file(washer, {"--warm", "--until", "25", "--replay", "20"});
  const auto [replayed, intervals] = expect_no_difference(print);
  EXPECT_EQ(replayed, 20);
  EXPECT_GE(intervals, 95);
  EXPECT_NE(print.job.output.find("--replay-seed"), std::string::npos);
}

TEST(replay_prints, intervals_at_random_are_the_same_at_50_mhz) {
  const Print print =
      print_file(washer, {"--warm", "--until", "10", "--clock-hz", "50000000", "--replay", "40"});
  EXPECT_EQ(expect_no_difference(print).first, 40);
}

// With damage on the line, and with interrupts in the middle of everything.
TEST(replay_prints, all_intervals_are_the_same_with_faults_and_with_steps_by_software) {
  const std::string gcode =
      "M106 S77\nM104 S190\nG28 X Y\nG1 X20 Y10 F6000\nG1 X0.5 Y7.3 F900\nG4 P300\nM105\n";
  const Print faulty = print_text(
      gcode, {"--fault", "serial=0.005", "--fault", "x-end-stop-bounces", "--replay", "all"});
  const auto [replayed, intervals] = expect_no_difference(faulty);
  EXPECT_EQ(replayed, intervals);
  const Print software =
      print_text("G28 X\nG1 X3 F9000\nG1 X2.5 Y7.3\n",
                 {"--clock-hz", "16000000", "--stepping", "software", "--replay", "all"});
  const auto [of_software, all_of_software] = expect_no_difference(software);
  EXPECT_EQ(of_software, all_of_software);
}

TEST(replay_prints, are_refused_where_there_is_no_model_to_check) {
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{"--replay", "1", "--every-clock"},
        {"--replay", "all", "--processor", "netlist"},
        {"--replay", "0"},
        {"--replay", "some"},
        {"--replay-seed", "1"}}) {
    EXPECT_EQ(print_text("G28 X\n", options).job.status, 2) << options.front();
  }
}

TEST(whole_replay, every_clock_of_the_washer_is_the_same) {
  const auto [replayed, intervals] =
      expect_no_difference(print_file(washer, {"--warm", "--replay", "all"}));
  EXPECT_EQ(replayed, intervals);
  EXPECT_GT(intervals, 600);
}

}  // namespace
