// SPDX-License-Identifier: Apache-2.0
// A machine with two extruders prints in two colours, each motor to the step, and is protected.
#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "directories.hpp"
#include "tests/scenarios/job.hpp"
#include "tools/files/file_text.hpp"

namespace {

using scenarios::Print;

const std::string machine = PROJECT_DIRECTORY "/firmware/machines/two_extruders.toml";

// What the file asks of each extruder with relative E, in hundred-thousandths of a millimetre.
std::map<int, long> filament_of(const std::string& gcode) {
  std::map<int, long> filament;
  int tool = 0;
  std::istringstream lines(gcode);
  for (std::string line; std::getline(lines, line);) {
    line = line.substr(0, line.find(';'));
    if (line.starts_with('T')) tool = std::stoi(line.substr(1));
    const std::size_t e = line.find(" E");
    if (line.starts_with("G1 ") && e != std::string::npos) {
      filament[tool] += std::lround(std::stod(line.substr(e + 2)) * 1e5);
    }
  }
  return filament;
}

// Where each motor stands at the end, by the edges at its driver's pins alone.
std::map<std::string, long> walked(const std::filesystem::path& edges) {
  std::map<std::string, long> steps;
  std::ifstream file(edges);
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::istringstream row(line);
    std::string cycle, axis, direction;
    std::getline(row, cycle, ',');
    std::getline(row, axis, ',');
    std::getline(row, direction, ',');
    steps[axis] += std::stol(direction);
  }
  return steps;
}

TEST(two_extruders, print_in_two_colours_to_the_step) {
  constexpr double steps_per_mm = 95.5;
  const std::string gcode = files::text_of(PROJECT_DIRECTORY "/tests/scenarios/two_colours.gcode");
  const Print print = scenarios::print_text(gcode, {"--warm", "--machine", machine});
  ASSERT_EQ(print.job.status, 0) << print.job.output;
  EXPECT_EQ(print.report["result"], "completed");
  EXPECT_EQ(print.report["verdict"], "good");
  EXPECT_EQ(print.report["path"]["points_missed"], 0);
  EXPECT_EQ(print.report["queue"]["underruns"], 0);
  for (const char* axis : {"x", "y", "z", "e", "e1"}) {
    EXPECT_EQ(print.report["axes"][axis]["illegal_pulses"], 0) << axis;
    EXPECT_EQ(print.report["axes"][axis]["disabled_pulses"], 0) << axis;
    EXPECT_EQ(print.report["axes"][axis]["unasked_steps"], 0) << axis;
  }
  std::map<int, long> filament = filament_of(gcode);
  ASSERT_GT(filament[0], 0);
  ASSERT_GT(filament[1], 0);
  // The one that is used last has come forward again; the other is drawn back by swap_length_mm.
  constexpr long swap = 400'000;
  const int last = gcode.rfind("\nT1") > gcode.rfind("\nT0") ? 1 : 0;
  filament[1 - last] -= swap;
  std::map<std::string, long> steps = walked(print.edges);
  EXPECT_EQ(steps["e"], std::lround(static_cast<double>(filament[0]) * 1e-5 * steps_per_mm));
  EXPECT_EQ(steps["e1"], std::lround(static_cast<double>(filament[1]) * 1e-5 * steps_per_mm));
}

// As a fault of the first hotend, also while its tool is not in use.
TEST(two_extruders, are_both_protected) {
  const Print print = scenarios::print_text(
      "M104 S200 T0\nM104 S200 T1\nG28\nM109 S200 T0\nM109 S200 T1\nG4 S60\nM84\n",
      {"--warm", "--machine", machine, "--fault", "hotend1-open@20"});
  EXPECT_NE(print.job.status, 0);
  EXPECT_EQ(print.report["result"], "faulted");
  EXPECT_THAT(print.report["fault"].get<std::string>(), testing::HasSubstr("Heater_ID: 1"));
}

TEST(two_extruders, whose_second_heater_stays_on_are_switched_off_by_their_supply) {
  const Print print = scenarios::print_text(
      "M104 S200 T0\nG28\nM109 S200 T0\nG4 S60\nM84\n",
      {"--warm", "--machine", machine, "--fault", "hotend1-heater-stuck-on@5"});
  EXPECT_NE(print.job.status, 0);
  EXPECT_EQ(print.report["result"], "faulted");
  EXPECT_LT(print.report["hotend_1"]["max_c"].get<double>(), 285);
}

TEST(two_extruders, need_the_model_of_the_processor_and_the_step_generator) {
  const Print netlist =
      scenarios::print_text("G28\n", {"--machine", machine, "--processor", "netlist"});
  EXPECT_NE(netlist.job.status, 0);
  EXPECT_THAT(netlist.job.output, testing::HasSubstr("omit --processor"));
  const Print software =
      scenarios::print_text("G28\n", {"--machine", machine, "--stepping", "software"});
  EXPECT_NE(software.job.status, 0);
  EXPECT_THAT(software.job.output, testing::HasSubstr("omit --stepping software"));
}

}  // namespace
