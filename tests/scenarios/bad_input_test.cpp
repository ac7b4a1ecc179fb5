// SPDX-License-Identifier: Apache-2.0
// Input that no printer should obey: a clear message, no motion and no heat from it, and the print
// goes on.
#include <gmock/gmock.h>

#include <fstream>
#include <string>

#include "tests/scenarios/job.hpp"

namespace {

using scenarios::print_file;
using scenarios::print_text;

long steps_made(const nlohmann::json& report, const char* axis) {
  const auto& numbers = report["axes"][axis];
  return numbers["steps_forward"].get<long>() + numbers["steps_backward"].get<long>();
}

TEST(bad_input, a_missing_file_is_named_and_nothing_is_simulated) {
  const auto print = print_file("no/such/file.gcode");
  EXPECT_EQ(print.job.status, 2);
  EXPECT_THAT(print.job.output, testing::HasSubstr("no/such/file.gcode does not exist"));
}

TEST(bad_input, a_binary_file_is_refused_before_anything_moves) {
  std::string bytes = "G28\n";
  for (int i = 0; i < 4000; ++i) bytes += static_cast<char>(i * 7919 >> 3);
  const auto print = print_text(bytes);
  EXPECT_EQ(print.job.status, 2);
  EXPECT_THAT(print.job.output, testing::HasSubstr("not a G-code file"));
  EXPECT_EQ(print.report["result"], "faulted");
}

// The firmware refuses the first target and takes the second.
TEST(bad_input, a_target_beyond_what_the_hotend_may_have_does_not_warm_it) {
  const auto print = print_text("M104 S400\nM109 S205\nG28 X\n", {"--warm"});
  EXPECT_THAT(print.job.output,
              testing::HasSubstr("--warm does not start the hotend near 400 °C: its highest target "
                                 "is 260 °C"));
  EXPECT_THAT(print.job.output, testing::HasSubstr("Above the highest target of 260.00"));
  EXPECT_EQ(print.report["result"], "completed");
  EXPECT_LT(print.report["hotend"]["max_c"].get<double>(), 210);
  EXPECT_LT(print.report["simulated_seconds"].get<double>(), 40);
}

// Every kind of bad line between good ones, cold: the good ones are executed, the bad
// ones are named.
TEST(bad_input, bad_lines_are_reported_and_the_good_ones_around_them_are_executed) {
  const std::string gcode =
      "G28 X Y\n"
      "G1 X10 Y10 F6000\n"
      "G999\n"
      "G1 X500\n"
      "G1 Y-3\n"
      "G1 E10 F300\n"
      "G1 X99999999999999999999999\n"
      "G1 X1.2.3\n"
      "G1 X" +
      std::string(10'000, '1') +
      "\n"
      "M104 S900\n"
      "G1 X20 Y15 F6000\n";
  const auto print = print_text(gcode);
  EXPECT_EQ(print.job.status, 1) << print.job.output;
  EXPECT_EQ(print.report["result"], "completed");
  EXPECT_EQ(print.report["verdict"], "bad");
  // All but M104, which the firmware cuts to what the machine stands.
  EXPECT_EQ(print.report["lines"]["refused"], 8);
  EXPECT_THAT(print.job.output, testing::HasSubstr("line 4: G1 X500: Move beyond the end of X"));
  EXPECT_TRUE(print.said("Unknown command: \"G999\""));
  EXPECT_TRUE(print.said("Move beyond the end of X"));
  EXPECT_TRUE(print.said("Move beyond the end of Y"));
  EXPECT_TRUE(print.said("cold extrusion prevented"));
  EXPECT_TRUE(print.said("G1 X99999999999999999999999"));
  EXPECT_TRUE(print.said("G1 X1.2.3"));
  EXPECT_TRUE(print.said("Line too long"));
  EXPECT_EQ(print.report["axes"]["x"]["final_position_steps"], 20 * 80);
  EXPECT_EQ(print.report["axes"]["y"]["final_position_steps"], 15 * 80);
  EXPECT_EQ(steps_made(print.report, "e"), 0);
  EXPECT_EQ(steps_made(print.report, "z"), 0);
  EXPECT_LT(print.report["hotend"]["max_c"].get<double>(), 30.0);
}

TEST(bad_input, an_emergency_stop_ends_the_print_as_faulted) {
  const auto print = print_text("G28 X\nG1 X100 F600\nM112\nG1 X0\n");
  EXPECT_EQ(print.job.status, 1);
  EXPECT_EQ(print.report["result"], "faulted");
  EXPECT_TRUE(print.said("kill() called"));
}

TEST(bad_input, an_open_thermistor_stops_the_print_with_the_heat_off) {
  const auto print = print_text("M104 S205\nG28 X\nG4 S20\n", {"--fault", "hotend-open@1"});
  EXPECT_EQ(print.job.status, 1);
  EXPECT_EQ(print.report["result"], "faulted");
  EXPECT_TRUE(print.said("thermistor open"));
  EXPECT_LT(print.report["hotend"]["max_c"].get<double>(), 60.0);
}

}  // namespace
