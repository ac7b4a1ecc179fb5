// SPDX-License-Identifier: Apache-2.0
// A wrong print is red: its exit status, its summary and its report say so, with the
// lines to blame.
#include <gmock/gmock.h>

#include <string>

#include "tests/scenarios/job.hpp"

namespace {

using scenarios::Print;
using scenarios::print_text;
using testing::HasSubstr;

std::vector<int> lines_of(const nlohmann::json& list) {
  std::vector<int> lines;
  for (const auto& entry : list) lines.push_back(entry["file_line"].get<int>());
  return lines;
}

TEST(verdict, is_bad_where_moves_and_heat_are_refused_and_names_the_lines) {
  const Print print = print_text(
      "G28 X Y\nG1 X30 Y10 F9000\nG2 X40 Y10 I9 J0\nG999\nT1\nM104 T1 S200\nG38.2 X5\nG1 X31\n");
  EXPECT_EQ(print.job.status, 1) << print.job.output;
  EXPECT_EQ(print.report["result"], "completed");
  EXPECT_EQ(print.report["verdict"], "bad");
  EXPECT_THAT(lines_of(print.report["refused_lines"]), testing::ElementsAre(3, 4, 5, 6, 7));
  EXPECT_EQ(print.report["refused_lines"][0]["reason"], "arc's end is not on its circle");
  EXPECT_EQ(print.report["refused_lines"][1]["reason"], "Unknown command");
  EXPECT_EQ(print.report["path"]["points_missed"], 0);
  EXPECT_THAT(print.job.output, HasSubstr("5 lines that should move or heat refused"));
  EXPECT_THAT(print.job.output,
              HasSubstr("line 3: G2 X40 Y10 I9 J0: arc's end is not on its circle"));
}

TEST(verdict, is_good_where_only_codes_that_move_nothing_are_unknown) {
  const Print print = print_text("M863 M\nM9001 K30\nG28 X Y\nG1 X30 F9000\n");
  EXPECT_EQ(print.job.status, 0) << print.job.output;
  EXPECT_EQ(print.report["verdict"], "good");
  EXPECT_EQ(print.report["lines"]["warnings"], 2);
  EXPECT_THAT(lines_of(print.report["warnings"]), testing::ElementsAre(1, 2));
  EXPECT_THAT(print.job.output, HasSubstr("2 warnings"));
}

// Each line of 5 um steps no axis, or one step of four.
TEST(verdict, is_good_for_moves_shorter_than_a_step) {
  std::string gcode = "G28 X Y\nG1 X20 F6000\n";
  for (int i = 1; i <= 100; ++i) gcode += "G1 X20." + std::to_string(1000 + 5 * i).substr(1) + "\n";
  const Print print = print_text(gcode + "G1 X20\nG1 X30\n");
  EXPECT_EQ(print.job.status, 0) << print.job.output;
  EXPECT_EQ(print.report["path"]["points_reached"], 103);
}

// The second line requests a step in 0.125 s.
TEST(verdict, is_good_for_a_line_of_eight_steps_a_second) {
  const Print print = print_text("G91\nG1 X1 F600\nG1 X0.2 F6\nG1 X1 F600\n");
  EXPECT_EQ(print.job.status, 0) << print.job.output;
  EXPECT_EQ(print.report["queue"]["underruns"], 0);
  EXPECT_GT(print.report["simulated_seconds"], 2.2);
}

TEST(verdict, is_bad_where_a_heater_cannot_be_as_hot_as_the_file_asks) {
  const Print print = print_text("M190 S109\nG91\nG1 X1 F600\n");
  EXPECT_EQ(print.job.status, 1) << print.job.output;
  EXPECT_THAT(print.job.output, HasSubstr("line 1: M190 S109: Above the highest target of 105.00"));
}

TEST(verdict, is_bad_where_an_extrusion_is_prevented) {
  const Print print = print_text("G28 X Y\nG1 X30 E5 F9000\nM83\nG1 X31 E1\nG1 X32\n");
  EXPECT_EQ(print.job.status, 1) << print.job.output;
  EXPECT_EQ(print.report["path"]["points_missed"], 2);
  EXPECT_EQ(print.report["path"]["points_missed_by_axis"]["e"], 2);
  EXPECT_EQ(print.report["path"]["points_missed_by_axis"]["x"], 0);
  EXPECT_THAT(lines_of(print.report["missed_points"]), testing::ElementsAre(2, 4));
  EXPECT_EQ(print.report["missed_points"][0]["axes"]["e"]["wanted_mm"], 5);
}

// Faster than the motor can follow.
TEST(verdict, is_bad_where_a_motor_slips) {
  const Print print = print_text(
      "G28 X Y\nM203 X900\nM201 X60000\nM204 T60000\nM205 X200\nG1 X150 F60000\nG1 X10\n");
  EXPECT_EQ(print.job.status, 1) << print.job.output;
  EXPECT_GT(print.report["axes"]["x"]["slipped_steps"], 0);
  EXPECT_THAT(print.job.output, HasSubstr("steps lost by the motors: X"));
  EXPECT_GT(print.report["path"]["points_missed_by_axis"]["x"], 0);
}

TEST(verdict, judges_g92_relative_and_inch_moves_z_and_e_by_their_steps) {
  const Print print = print_text(
      "M104 S200\nG28\nM109 S200\nG1 X30 Y10.00625 Z2.0002 F6000\nG92 X100 E7\nG1 X101.3 E7.5 "
      "F1200\n"
      "G91\nG1 X0.3 Y-0.0125 E0.033 F6000\nG1 Z-0.1\nG20\nG1 X0.01 E0.001\nG21\nG90\nM221 S50\n"
      "G1 X120 E8\nM220 S50\nG1 X100 E7\n",
      {"--warm"});
  EXPECT_EQ(print.job.status, 0) << print.job.output;
  EXPECT_EQ(print.report["path"]["points_reached"], 7);
}

TEST(verdict, is_good_for_a_file_that_carries_numbers_prompts_and_odd_bytes) {
  const Print print = print_text(
      "; Gr\xf6\xdf"
      "e\r\nN1 G28 X Y*19\r\nM110 N55\r\n\tg1 x10\tf6000\r\nM117 5*3 gr\xc3\xbcn\r\n"
      "M0\r\nG1 X20\r\nM0 S1 Wait\r\nM1 Press\r\nG1 X30 ; last",
      {"--window", "4", "--baud", "1000000"});
  EXPECT_EQ(print.job.status, 0) << print.job.output;
  EXPECT_EQ(print.report["path"]["points_reached"], 3);
  EXPECT_EQ(print.report["resends"], 0);
  EXPECT_THAT(print.job.output, HasSubstr("line 3 \"M110 N55\" is not sent"));
  EXPECT_THAT(print.job.output, HasSubstr("line 6 \"M0\" waits for the user: answered"));
  EXPECT_THAT(print.job.output, HasSubstr("line 9 \"M1 Press\" waits for the user: answered"));
}

TEST(verdict, is_bad_where_a_prompt_may_not_be_answered) {
  const Print print = print_text("G28 X\nM0\nG1 X10\n", {"--no-answer"});
  EXPECT_EQ(print.job.status, 1) << print.job.output;
  EXPECT_EQ(print.report["result"], "faulted");
  EXPECT_THAT(print.job.output, HasSubstr("line 2 \"M0\" waits for the user"));
  EXPECT_EQ(print.report["lines"]["lost"], 2);
}

TEST(verdict, is_good_on_a_noisy_line_with_several_lines_in_flight) {
  std::string gcode = "G28 X Y\n";
  for (int i = 1; i <= 60; ++i) {
    gcode += "G1 X" + std::to_string(i) + " Y" + std::to_string(i % 3) + " F9000\n";
  }
  const Print print = print_text(gcode, {"--window", "4", "--fault", "serial=0.003"});
  EXPECT_EQ(print.job.status, 0) << print.job.output;
  EXPECT_GT(print.report["resends"], 0);
  EXPECT_EQ(print.report["path"]["points_reached"], 60);
}

TEST(verdict, names_a_higher_clock_where_the_processor_is_the_limit) {
  std::string gcode = "G28 X Y\nG1 F12000\n";
  for (int i = 1; i <= 250; ++i) gcode += "G1 X" + std::to_string(0.2 * i) + "\n";
  const Print print = print_text(gcode, {"--window", "4", "--baud", "1000000"});
  EXPECT_GT(print.report["processor"]["saturated_seconds"], 0);
  EXPECT_THAT(print.job.output, HasSubstr("try --clock-hz 8000000"));
  const Print quick = print_text("G28 X Y\nG1 X10\n");
  EXPECT_THAT(quick.job.output, testing::Not(HasSubstr("try --clock-hz")));
}

TEST(verdict, refuses_options_that_cannot_be) {
  EXPECT_EQ(print_text("G28\n", {"--window", "0"}).job.status, 2);
  EXPECT_EQ(print_text("G28\n", {"--window", "9"}).job.status, 2);
  EXPECT_EQ(print_text("G28\n", {"--baud", "300"}).job.status, 2);
  const Print print = print_text("G28\n", {"--baud", "3000000"});
  EXPECT_EQ(print.job.status, 2);
  EXPECT_THAT(print.job.output, HasSubstr("need a chip of at least 12000000 Hz"));
}

}  // namespace
