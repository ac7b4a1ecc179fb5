// SPDX-License-Identifier: Apache-2.0
// The netlist of the whole chip does parts of a print again, and comes to the same.
#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "directories.hpp"
#include "tests/scenarios/job.hpp"

namespace {

using scenarios::Print;
using scenarios::print_file;
using scenarios::print_text;

const std::string washer = PROJECT_DIRECTORY "/examples/washer.gcode";

TEST(replay_prints, intervals_at_random_are_the_same_at_4_mhz) {
  const Print print = print_file(washer, {"--warm", "--until", "25", "--replay", "20"});
  const auto [replayed, intervals] = scenarios::expect_no_difference(print);
  EXPECT_EQ(replayed, 20);
  EXPECT_GE(intervals, 95);
  EXPECT_NE(print.job.output.find("--replay-seed"), std::string::npos);
}

TEST(replay_prints, intervals_at_random_are_the_same_at_50_mhz) {
  const Print print =
      print_file(washer, {"--warm", "--until", "10", "--clock-hz", "50000000", "--replay", "40"});
  EXPECT_EQ(scenarios::expect_no_difference(print).first, 40);
}

// With damage on the line.
TEST(replay_prints, all_intervals_are_the_same_with_faults) {
  const std::string gcode =
      "M106 S77\nM104 S190\nG28 X Y\nG1 X20 Y10 F6000\nG1 X0.5 Y7.3 F900\nG4 P300\nM105\n";
  const Print faulty = print_text(
      gcode, {"--fault", "serial=0.005", "--fault", "x-end-stop-bounces", "--replay", "all"});
  const auto [replayed, intervals] = scenarios::expect_no_difference(faulty);
  EXPECT_EQ(replayed, intervals);
}

TEST(replay_prints, intervals_of_a_range_are_the_same_without_leaps_and_rests) {
  const Print print =
      print_file(washer, {"--warm", "--until", "12", "--replay", "31-34", "--replay-every-clock"});
  const auto [replayed, intervals] = scenarios::expect_no_difference(print);
  EXPECT_EQ(replayed, 4);
  EXPECT_GE(intervals, 40);
}

TEST(replay_prints, a_range_after_the_end_fails) {
  const Print print = print_text("G28 X\n", {"--replay", "5000-5001"});
  EXPECT_EQ(print.job.status, 1) << print.job.output;
  EXPECT_NE(print.job.output.find("no interval was compared: choose from 1 to "), std::string::npos)
      << print.job.output;
}

TEST(replay_prints, what_the_end_of_the_print_leaves_out_is_said) {
  const Print print = print_text("G4 P1\n", {"--replay", "1-5000"});
  const auto [replayed, intervals] = scenarios::expect_no_difference(print);
  EXPECT_EQ(replayed, intervals);
  EXPECT_NE(print.job.output.find("the print ended before interval 5000"), std::string::npos)
      << print.job.output;
  EXPECT_NE(print.job.output.find("only its pins were compared"), std::string::npos)
      << print.job.output;
}

TEST(replay_prints, are_refused_where_there_is_no_model_to_check) {
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{"--replay", "1", "--every-clock"},
        {"--replay", "all", "--processor", "netlist"},
        {"--replay", "all", "--board", "ulx3s"},
        {"--replay", "all", "--trace", "trace.fst"},
        {"--replay", "0"},
        {"--replay", "some"},
        {"--replay", "0-4"},
        {"--replay", "4-3"},
        {"--replay", "3-"},
        {"--replay", "-3"},
        {"--replay-every-clock"},
        {"--replay-seed", "1"}}) {
    const Print print = print_text("G28 X\n", options);
    EXPECT_EQ(print.job.status, 2) << testing::PrintToString(options);
    EXPECT_TRUE(print.report.is_null()) << testing::PrintToString(options);
  }
}

}  // namespace
