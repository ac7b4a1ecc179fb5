// SPDX-License-Identifier: Apache-2.0
// Wires, switches and capacitors that fail while the printer works: the print is right in the end,
// or ends with the fault's name and without heat.
#include <gmock/gmock.h>

#include <string>

#include "tests/scenarios/job.hpp"

namespace {

using scenarios::Print;
using scenarios::print_text;

// Of 200 ms each.
std::string moves(int count) {
  std::string gcode = "G28 X Y\nG1 F3000\n";
  for (int i = 1; i <= count; ++i) {
    gcode += "G1 X" + std::to_string(10 + 10 * (i % 2)) + " Y" + std::to_string(i % 7) + "\n";
  }
  return gcode;
}

void expect_all(const Print& print, int points) {
  EXPECT_EQ(print.job.status, 0) << print.job.output;
  EXPECT_EQ(print.report["result"], "completed");
  EXPECT_EQ(print.report["path"]["points_reached"], points);
  EXPECT_EQ(print.report["path"]["points_missed"], 0);
}

// Of the long lines that keep the wire busy some are on it when it is cut.
TEST(part_faults, a_cable_that_is_pulled_and_put_in_again_loses_and_doubles_no_line) {
  std::string gcode = "G91\nG1 F3000\n";
  for (int i = 0; i < 12; ++i) {
    gcode += "G1 X1 Y" + std::to_string(i % 3) + "\n";
    for (int j = 0; j < 40; ++j) gcode += "M117 " + std::string(100, 'x') + "\n";
  }
  const Print print = print_text(
      gcode, {"--window", "4", "--fault", "cable-pulled=3@0.5", "--fault", "cable-pulled=0.2@4.5"});
  expect_all(print, 12);
  EXPECT_GT(print.report["resends"], 0);
  EXPECT_GT(print.report["simulated_seconds"], 5);
}

TEST(part_faults, noise_on_the_way_to_the_host_loses_and_doubles_no_line) {
  for (const char* window : {"1", "4"}) {
    const Print print = print_text(moves(60), {"--window", window, "--fault", "replies=0.02"});
    expect_all(print, 60);
  }
}

TEST(part_faults, homing_on_end_stops_that_bounce_is_exact) {
  for (const char* seed : {"1", "2"}) {
    const Print print = print_text("G28\nG1 X30 Y20 Z2 F6000\nG28 X\nG1 X10\nG1 Y0\nG28 Y\nG1 Y5\n",
                                   {"--seed", seed, "--fault", "x-end-stop-bounces", "--fault",
                                    "y-end-stop-bounces", "--fault", "z-end-stop-bounces"});
    EXPECT_EQ(print.job.status, 0) << print.job.output;
    EXPECT_EQ(print.report["path"]["points_missed"], 0);
    EXPECT_EQ(print.report["axes"]["x"]["final_position_steps"], 10 * 80);
    EXPECT_EQ(print.report["axes"]["y"]["final_position_steps"], 5 * 80);
    EXPECT_EQ(print.report["axes"]["z"]["final_position_steps"], 2 * 2560);
  }
}

// The two references are measured with the same capacitor, so its value cancels.
TEST(part_faults, a_capacitor_of_another_value_changes_no_temperature) {
  for (const char* factor : {"0.5", "1.5"}) {
    const Print print =
        print_text("M109 S205\nG4 S60\nG28 X\n",
                   {"--warm", "--fault", std::string("hotend-capacitor=") + factor + "@30"});
    EXPECT_EQ(print.job.status, 0) << print.job.output;
    EXPECT_LT(print.report["hotend"]["max_c"].get<double>(), 212);
    EXPECT_LT(print.report["hotend"]["band_c"].get<double>(), 4);
  }
}

TEST(part_faults, a_lost_capacitor_ends_the_print_without_heat) {
  const Print print =
      print_text("M109 S205\nG4 S60\nG28 X\n", {"--warm", "--fault", "hotend-capacitor-lost@30"});
  EXPECT_EQ(print.job.status, 1) << print.job.output;
  EXPECT_EQ(print.report["result"], "faulted");
  EXPECT_TRUE(print.said("thermistor shorted") || print.said("sensor implausible") ||
              print.said("heater cut off by the hardware"))
      << print.job.output;
  EXPECT_LT(print.report["hotend"]["max_c"].get<double>(), 212);
}

}  // namespace
