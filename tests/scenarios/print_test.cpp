// SPDX-License-Identifier: Apache-2.0
// Real prints on the whole chip: every point is reached to the step, no pulse is illegal,
// at any clock.
#include <gmock/gmock.h>

#include <fstream>
#include <sstream>
#include <string>
#include <tuple>

#include "directories.hpp"
#include "tests/scenarios/job.hpp"
#include "tools/files/file_text.hpp"
#include "tools/process/process.hpp"

namespace {

using scenarios::Print;
using scenarios::print_file;
using scenarios::print_text;

const std::string washer = PROJECT_DIRECTORY "/examples/washer.gcode";

std::string first_lines(const std::string& file, int count) {
  std::ifstream stream(file);
  std::string text, line;
  while (count-- > 0 && std::getline(stream, line)) text += line + "\n";
  return text;
}

constexpr double chord_deviation_mm = 0.005;

void expect_clean(const Print& print, double deviation_mm = 0) {
  ASSERT_EQ(print.job.status, 0) << print.job.output;
  EXPECT_EQ(print.report["result"], "completed");
  for (const char* axis : {"x", "y", "z", "e"}) {
    EXPECT_EQ(print.report["axes"][axis]["illegal_pulses"], 0) << axis;
  }
  EXPECT_EQ(print.report["queue"]["underruns"], 0);
  EXPECT_EQ(print.report["path"]["points_missed"], 0);
  EXPECT_LE(print.report["path"]["max_deviation_mm"].get<double>(), 1.0 / 80 + deviation_mm);
  const double target_c = print.report["hotend"]["target_c"].get<double>();
  if (target_c > 0) {
    EXPECT_LT(print.report["hotend"]["max_c"].get<double>(), target_c + 5.0);
  }
}

// The judge that shares nothing with firmware and simulation.
void expect_edges_as_requested(const std::string& gcode, const Print& print, int clock_hz,
                               double tolerance_steps = 1) {
  const std::string step_us = std::to_string(2 * (clock_hz / 1'000'000));
  const process::Start check{.arguments = {BUILD_DIRECTORY "/bin/check_edges", gcode,
                                           print.edges.string(), "--shortest-interval", step_us,
                                           "--tolerance", std::to_string(tolerance_steps)}};
  EXPECT_EQ(process::run(check).exit_status, 0);
}

std::string totals(const Print& print) {
  std::string text;
  for (const char* axis : {"x", "y", "z", "e"}) {
    const auto& numbers = print.report["axes"][axis];
    text += std::to_string(numbers["steps_forward"].get<long>()) + "/" +
            std::to_string(numbers["steps_backward"].get<long>()) + " ";
  }
  return text;
}

TEST(print, the_first_lines_of_the_washer_are_made_to_the_step) {
  const std::string gcode = first_lines(washer, 110);
  const Print print = print_text(gcode, {"--warm"});
  expect_clean(print);
  expect_edges_as_requested((scenarios::scratch_folder() / "input.gcode").string(), print,
                            4'000'000);
  EXPECT_GT(print.report["hotend"]["target_c"].get<double>(), 200.0);
}

TEST(print, follows_work_offsets_and_leads_to_places_of_the_machine) {
  const Print print = print_text(
      "G28\nG1 X30 Y40 Z5 F6000\nG55\nG92 X0 Y0\nG1 X10 Y0\nG1 X10 Y10\nG53 G1 X20 Y20\nG60\nG54\n"
      "G1 X50 Y50\nG61 F3000\nG92.1\nM206 X1 Z0.2\nG1 X60 Y60 Z6\nG2 X70 Y60 I5 J0\nG59.3\nG92 Y0\n"
      "G1 Y5\nM206 X0 Y0 Z0\nG27 P2\nM84\n");
  expect_clean(print, chord_deviation_mm);
  EXPECT_EQ(print.report["axes"]["x"]["final_position_mm"], 10);
  EXPECT_NEAR(print.report["axes"]["y"]["final_position_mm"].get<double>(), 190, 0.01);
  EXPECT_NEAR(print.report["axes"]["z"]["final_position_mm"].get<double>(), 25.8, 0.01);
}

TEST(print, retraction_by_the_firmware_ends_to_the_step) {
  const std::string gcode =
      "M104 S200\nG28\nM109 S200\nG1 X20 Y20 Z0.3 E2 F3000\nG10\nG1 X30\nG11\nG1 X40 E2.5\n"
      "M207 S1.203 F1800 Z0.4\nM208 S0.017 F1200\nG92 E0\nG10\nG1 Y60 F6000\nG11\nM83\n"
      "G1 Y65 E0.25\nG10\nG10\nG91\nG1 X-5 Z0.3\nG90\nG11\nG1 X20 E0.7\n";
  const Print print = print_text(gcode, {"--warm"});
  expect_clean(print);
  expect_edges_as_requested((scenarios::scratch_folder() / "input.gcode").string(), print,
                            4'000'000);
  EXPECT_NEAR(print.report["axes"]["e"]["steps_backward"].get<double>(), (3 + 2 * 1.203) * 500, 2);
}

// In all planes, both directions, by centre and radius; helices, full circles, with E. A chord's
// middle is 0.005 mm nearer to the centre than its ends.
TEST(print, arcs_lie_on_their_circles_and_end_to_the_step) {
  const std::string gcode =
      "M104 S200\nG28\nM109 S200\nG1 X50 Y50 Z5 F6000\nG2 X70 I10 E1 F3000\nG3 X50 R10 E2\n"
      "G3 X60 Y60 R-10\nG2 I10 J0\nG3 I-0.5\nG2 X60.05 Y60.05 I0.05 J0\nG91\nM83\n"
      "G2 X7.0711 Y2.9289 I0 J10 E0.4 F6000\nG3 I3 J-4 Z0.3 E1.5\nG90\nG1 X100 Y100\n"
      "G3 I-30 J-20 F9000\nG18\nG2 X104 Z5.3 I2 K0 F300\nG19\nG3 Y104 Z6.3 R3\nG17\nG1 X90\n";
  const Print print = print_text(gcode, {"--warm"});
  expect_clean(print, chord_deviation_mm);
  expect_edges_as_requested((scenarios::scratch_folder() / "input.gcode").string(), print,
                            4'000'000, 1 + 80 * chord_deviation_mm);
  EXPECT_EQ(print.report["path"]["points_reached"], 14);
  EXPECT_LT(print.report["processor"]["longest_pass_clocks"].get<int>(), 44'000);
}

// Bytes and segments wait meanwhile: rtl/serial/README.md.
TEST(print, no_pass_of_the_firmware_is_long_while_it_watches_both_heaters) {
  const Print print = print_text(
      "M140 S60\nM109 S205\nM190 S60\nG28 X Y\nG1 X20 Y10 F6000\nG4 P40000\n", {"--warm"});
  expect_clean(print);
  EXPECT_LT(print.report["processor"]["longest_pass_clocks"].get<int>(), 44'000);
}

TEST(print, the_same_steps_are_made_at_every_clock) {
  const std::string gcode =
      "G28 X Y\nG1 X30 Y10 F9000\nG1 X32.5 Y17.3\nG1 X31 Y22\nG1 X5 Y5 F12000\nG1 X5.02\n";
  std::string reference;
  for (const int clock_hz : {4'000'000, 8'000'000, 50'000'000}) {
    const Print print = print_text(gcode, {"--clock-hz", std::to_string(clock_hz)});
    expect_clean(print);
    expect_edges_as_requested((scenarios::scratch_folder() / "input.gcode").string(), print,
                              clock_hz);
    if (reference.empty()) reference = totals(print);
    EXPECT_EQ(totals(print), reference) << clock_hz;
  }
}

// Each byte that a job leaves, but for how long it took.
auto left_by(const std::string& gcode, std::vector<std::string> options) {
  const auto accepted = scenarios::scratch_folder() / "accepted";
  options.insert(options.end(), {"--accept-log", accepted.string()});
  const Print print = print_text(gcode, options);
  EXPECT_EQ(print.job.status, 0) << print.job.output;
  nlohmann::json report = print.report;
  EXPECT_GT(report.erase("wall_seconds"), 0u);
  return std::tuple(files::text_of(print.edges), files::text_of(accepted), report.dump());
}

// With moves, heat, a fan, damage on the line and a fault.
TEST(print, every_clock_is_evaluated_to_the_same_edges_lines_and_figures) {
  const std::string gcode =
      "M106 S77\nM104 S190\nG28 X Y\nG1 X20 Y10 F6000\nG1 X0.5 Y7.3 F900\nG4 P300\nM105\n"
      "G1 X9 Y9 Z0.2 F7000\nM84\n";
  const auto run = [&](std::vector<std::string> options) {
    options.insert(options.end(), {"--fault", "serial=0.005", "--fault", "x-end-stop-bounces"});
    return left_by(gcode, options);
  };
  const auto quick = run({});
  EXPECT_GT(std::get<0>(quick).size(), 1000u);
  EXPECT_EQ(run({"--processor", "netlist"}), quick);
  EXPECT_EQ(run({"--every-clock"}), quick);
}

// On a noisy line, with another noise each time.
TEST(print, the_processor_s_model_and_its_netlist_leave_the_same) {
  const std::string gcode =
      "M104 S60\nG28 X Y\nG1 X20 Y10 F6000\nG1 X0.5 Y7.3 F900\nM105\nG1 X9 Y9 Z0.2 F7000\n";
  for (int seed = 1; seed <= 10; ++seed) {
    const std::vector<std::string> options{"--fault", "serial=0.01", "--seed",
                                           std::to_string(seed)};
    std::vector<std::string> by_netlist = options;
    by_netlist.insert(by_netlist.end(), {"--processor", "netlist"});
    EXPECT_EQ(left_by(gcode, by_netlist), left_by(gcode, options)) << "seed " << seed;
  }
}

// Which has the chip's memory, and no more.
TEST(software_stepping, is_refused_where_the_netlist_of_the_processor_is_asked_for) {
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{"--processor", "netlist"},
        {"--every-clock"},
        {"--replay", "all"},
        {"--trace", "chip.fst"},
        {"--board", "ulx3s"}}) {
    std::vector<std::string> all{"--stepping", "software"};
    all.insert(all.end(), options.begin(), options.end());
    const Print print = print_text("G28 X\n", all);
    EXPECT_EQ(print.job.status, 2) << options.front();
    EXPECT_NE(print.job.output.find("omit --processor netlist"), std::string::npos)
        << print.job.output;
  }
}

TEST(software_stepping, makes_the_same_steps_as_the_hardware) {
  const std::string gcode =
      "G28 X Y\nG1 X30 Y10 F9000\nG1 X32.5 Y17.3\nG1 X31 Y22\nG1 X5 Y5 F12000\nG1 X5.02\n";
  const Print hardware = print_text(gcode, {"--clock-hz", "16000000"});
  const Print software = print_text(gcode, {"--clock-hz", "16000000", "--stepping", "software"});
  expect_clean(software);
  expect_edges_as_requested((scenarios::scratch_folder() / "input.gcode").string(), software,
                            16'000'000);
  EXPECT_EQ(totals(software), totals(hardware));
  EXPECT_EQ(software.report["queue"]["late_ticks"], 0);
  EXPECT_GT(software.report["processor"]["busy_percent"],
            hardware.report["processor"]["busy_percent"]);
}

// And the netlist of the whole chip does every clock of it again.
TEST(whole_print, the_washer_is_printed_to_the_step_and_replayed_by_the_netlist) {
  const Print print = print_file(washer, {"--warm", "--replay", "all"});
  expect_clean(print);
  const auto [replayed, intervals] = scenarios::expect_no_difference(print);
  EXPECT_EQ(replayed, intervals);
  EXPECT_GT(intervals, 600);
  expect_edges_as_requested(washer, print, 4'000'000);
  EXPECT_LT(print.report["hotend"]["band_c"].get<double>(), 2.0);
}

}  // namespace
