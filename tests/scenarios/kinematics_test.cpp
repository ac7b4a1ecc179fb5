// SPDX-License-Identifier: Apache-2.0
// Machines whose motors are not their axes print to the step, on the whole chip.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <regex>
#include <string>
#include <vector>

#include "directories.hpp"
#include "tests/scenarios/job.hpp"
#include "tools/files/file_text.hpp"
#include "tools/process/process.hpp"

namespace {

using scenarios::Print;

// Lines in all directions, short and relative ones, an arc, and a second homing.
const std::string gcode =
    "M104 S200\nG28\nM109 S200\nG1 Z5 F2400\nG1 X20 Y20 Z0.3 F3000\nG1 X40 Y20 E1 F2400\n"
    "G1 X40 Y40 E2\nG1 X20 Y40 E3\nG1 X20 Y20 E4\nG1 X35 Y33 E5\nG2 X35 Y33 I5 J0 E6\nG91\n"
    "G1 X-3.333 Y1.017\nG1 X0.01 Y0.02 Z0.05\nG1 X-30 Y-25 Z2 F6000\nG90\nG28\n"
    "G1 X5 Y10 Z30 F6000\nM400\nM114\nM84\n";

Print print_on(const std::string& machine, const std::string& text = gcode) {
  Print print = scenarios::print_text(
      text, {"--warm", "--machine",
             std::string(PROJECT_DIRECTORY "/firmware/machines/") + machine + ".toml"});
  EXPECT_EQ(print.job.status, 0) << print.job.output;
  EXPECT_EQ(print.report["result"], "completed");
  EXPECT_EQ(print.report["path"]["points_missed"], 0);
  EXPECT_EQ(print.report["queue"]["underruns"], 0);
  return print;
}

void expect_edges_as_requested(const Print& print, std::vector<std::string> options) {
  std::vector<std::string> arguments{BUILD_DIRECTORY "/bin/check_edges",
                                     (scenarios::scratch_folder() / "input.gcode").string(),
                                     print.edges.string()};
  arguments.insert(arguments.end(), options.begin(), options.end());
  EXPECT_EQ(process::run({.arguments = arguments}).exit_status, 0);
}

TEST(kinematics, core_xy_prints_to_the_step) {
  const Print print = print_on("core_xy");
  expect_edges_as_requested(print, {"--kinematics", "core_xy", "--steps-per-mm", "80", "80", "400",
                                    "95.5", "--tolerance", "1.5"});
  EXPECT_TRUE(print.said("Count A:1200 B:-400 Z:12000"));
}

TEST(kinematics, delta_prints_to_the_step_and_within_its_chords) {
  const Print print = print_on("delta");
  expect_edges_as_requested(
      print, {"--kinematics", "delta", "--rod", "250", "--radius", "105", "--height", "250",
              "--steps-per-mm", "80", "80", "80", "95.5", "--tolerance", "3"});
}

// The same between the circles about the shoulder, where the arms turn back within lines.
TEST(kinematics, scara_prints_to_the_step_and_within_its_chords) {
  const Print print = print_on(
      "scara",
      "M104 S200\nG28\nM109 S200\nG1 Z145 F1200\nG1 X60 Y60 Z140.3 F3000\nG1 X90 Y60 E1 F2400\n"
      "G1 X90 Y90 E2\nG1 X60 Y90 E3\nG1 X60 Y60 E4\nG1 X15 Y10\nG1 X190 Y170 E9\n"
      "G1 X75 Y73 E5\nG2 X75 Y73 I5 J0 E6\nG91\nG1 X-3.333 Y1.017\nG1 X0.01 Y0.02 Z0.05\n"
      "G1 X-30 Y-25 Z2 F6000\nG90\nG28\nG1 X5 Y110 Z130 F6000\nM400\nM114\nM84\n");
  expect_edges_as_requested(
      print,
      {"--kinematics",   "scara", "--arms", "200",    "180",  "--shoulder",  "100",      "-120",
       "--end-stops",    "100",   "215",    "--home", "10",   "60",          "--height", "150",
       "--steps-per-mm", "160",   "160",    "400",    "95.5", "--tolerance", "1.5"});
}

TEST(kinematics, needs_the_model_of_the_processor_where_the_machine_has_more_memory) {
  const Print print = scenarios::print_text(
      "G28\n",
      {"--machine", PROJECT_DIRECTORY "/firmware/machines/core_xy.toml", "--processor", "netlist"});
  EXPECT_NE(print.job.status, 0);
  EXPECT_THAT(print.job.output, testing::HasSubstr("memory_kib"));
}

// A delta whose chip has the default's memory, or as much as is given.
scenarios::JobResult answering_delta_with(const std::string& memory) {
  const std::string line = "memory_kib = 128";
  std::string machine = files::text_of(PROJECT_DIRECTORY "/firmware/machines/delta.toml");
  const std::size_t place = machine.find(line);
  EXPECT_NE(place, std::string::npos);
  machine.replace(place, line.size(), memory);
  const auto file = scenarios::scratch_folder() / "delta.toml";
  scenarios::write_file(file, machine);
  return scenarios::print_text("M115\n", {"--machine", file.string()}).job;
}

// What it says is enough, and less is not.
TEST(kinematics, says_how_much_memory_its_firmware_needs) {
  const scenarios::JobResult small = answering_delta_with("");
  EXPECT_NE(small.status, 0);
  static const std::regex words(
      "delta.toml: the firmware for this machine needs (\\d+) KiB of memory, and its chip has 104: "
      "set memory_kib = (\\d+)");
  std::smatch match;
  ASSERT_TRUE(std::regex_search(small.output, match, words)) << small.output;
  EXPECT_EQ(match[1], match[2]);
  const int kib = std::stoi(match[1]);
  const auto enough = answering_delta_with(fmt::format("memory_kib = {}", kib));
  EXPECT_EQ(enough.status, 0) << enough.output;
  if (kib == 108) return;
  const auto less = answering_delta_with(fmt::format("memory_kib = {}", kib - 4));
  EXPECT_NE(less.status, 0);
  EXPECT_THAT(less.output, testing::HasSubstr(fmt::format("set memory_kib = {}", kib)));
}

}  // namespace
