// SPDX-License-Identifier: Apache-2.0
// A first layer above the uneven bed of a simulated printer, on the whole chip, judged by the
// report and by the step edges; and probes that fail.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "directories.hpp"
#include "tests/scenarios/edge_rows.hpp"
#include "tests/scenarios/job.hpp"

namespace {

using scenarios::Print;
using testing::HasSubstr;

constexpr const char* machine = PROJECT_DIRECTORY "/firmware/machines/probed_bed_slinger.toml";
constexpr double steps_per_mm[] = {80, 80, 400};
constexpr double layer_mm = 0.3;

// As [bed_surface] of the machine describes it, 220 mm wide and deep.
double bed(double x, double y) {
  const double u = x / 220, v = y / 220;
  const double tilted =
      0.15 * (1 - u) * (1 - v) - 0.2 * u * (1 - v) - 0.1 * (1 - u) * v + 0.25 * u * v;
  return tilted - 0.15 * 16 * u * (1 - u) * v * (1 - v);
}

// Lines in all directions and an arc; E turns in this layer only.
std::string first_layer(const std::string& levelling) {
  return "M104 S200\nG28\n" + levelling +
         "M109 S200\nG1 X30 Y20 Z0.3 F6000\nG1 X200 Y20 E8 F6000\nG1 X200 Y190 E16\n"
         "G1 X30 Y20 E26\nG1 X35 Y195 E34\nG1 X150 Y100 E42\nG2 X150 Y100 I-35 J-30 E56\n"
         "M400\nG1 Z5 F1200\nM84\n";
}

struct Heights {
  double lowest = 1e9, highest = -1e9;
  std::size_t steps{};  // of the extruder
};

// Of the nozzle above the bed, wherever the extruder makes a step.
Heights heights_of(const Print& print) {
  const scenarios::Edges edges = scenarios::read_edges(print.edges.string());
  Heights heights;
  scenarios::Position at = edges.start;
  for (const scenarios::Instant& instant : edges.instants) {
    for (std::size_t axis = 0; axis < at.size(); ++axis) at[axis] += instant.step[axis];
    if (instant.step[3] == 0) continue;
    double mm[3];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      mm[axis] = static_cast<double>(at[axis]) / steps_per_mm[axis];
    }
    const double height = mm[2] - bed(mm[0], mm[1]);
    heights.lowest = std::min(heights.lowest, height);
    heights.highest = std::max(heights.highest, height);
    ++heights.steps;
  }
  return heights;
}

Print print_on_it(const std::string& gcode, std::vector<std::string> options = {}) {
  options.insert(options.end(), {"--warm", "--machine", machine});
  return scenarios::print_text(gcode, options);
}

// 25 points of the mesh leave 13 um of the bed's bend; the rest is for steps and chords.
TEST(levelling, keeps_the_nozzle_at_its_height_above_an_uneven_bed) {
  const Print print = print_on_it(first_layer("G29\nM420 V\n"));
  EXPECT_EQ(print.job.status, 0) << print.job.output;  // judged by the mesh
  EXPECT_EQ(print.report["queue"]["underruns"], 0);
  EXPECT_TRUE(print.said("Bilinear Leveling Grid:"));
  EXPECT_TRUE(print.said("echo:Bed Leveling ON"));
  const Heights heights = heights_of(print);
  EXPECT_GT(heights.steps, 5000u);
  EXPECT_GT(heights.lowest, layer_mm - 0.02);
  EXPECT_LT(heights.highest, layer_mm + 0.02);
  std::printf("%.4f to %.4f mm above the bed\n", heights.lowest, heights.highest);
}

TEST(levelling, is_what_keeps_it_there) {
  const Print print = print_on_it(first_layer(""));
  EXPECT_EQ(print.job.status, 0) << print.job.output;  // as the file says
  const Heights heights = heights_of(print);
  EXPECT_GT(heights.steps, 5000u);
  EXPECT_LT(heights.lowest, layer_mm - 0.1);
  EXPECT_GT(heights.highest, layer_mm + 0.1);
}

// The lowest of the nozzle, in mm, once it has been lifted after homing.
double lowest_after_homing(const Print& print) {
  const scenarios::Edges edges = scenarios::read_edges(print.edges.string());
  double lowest = 1e9, z = static_cast<double>(edges.start[2]) / steps_per_mm[2];
  bool homed = false, lifted = false;
  for (const scenarios::Instant& instant : edges.instants) {
    if (instant.step[2] == 0) continue;
    z += static_cast<double>(instant.step[2]) / steps_per_mm[2];
    homed = homed || z <= 0;
    lifted = lifted || (homed && z > 3.9);
    if (lifted) lowest = std::min(lowest, z);
  }
  return lowest;
}

TEST(levelling, halts_above_the_bed_where_the_probe_does_not_trigger) {
  const Print print = print_on_it(first_layer("G29\n"), {"--fault", "probe-never-closes"});
  EXPECT_NE(print.job.status, 0);
  EXPECT_TRUE(print.said("Error:Probing Failed at X25.00 Y10.00: not triggered"));
  // The deepest place of the bed, -1 mm, and the probe's 1.2 mm.
  EXPECT_NEAR(lowest_after_homing(print), 0.2, 0.01);
  EXPECT_EQ(heights_of(print).steps, 0u);
}

TEST(levelling, halts_before_the_descent_where_the_probe_is_triggered) {
  const Print print = print_on_it(first_layer("G29\n"), {"--fault", "probe-never-opens"});
  EXPECT_NE(print.job.status, 0);
  EXPECT_TRUE(print.said("triggered before its descent"));
  EXPECT_GT(lowest_after_homing(print), 3.9);
}

}  // namespace
