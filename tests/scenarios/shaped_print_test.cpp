// SPDX-License-Identifier: Apache-2.0
// The resonance test on the whole chip: its step edges drive a mode of vibration of X, whose
// ringing behind a corner is compared with that of the same print without a shaper.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cstdint>
#include <string>

#include "directories.hpp"
#include "sim/plants/vibration.hpp"
#include "tests/scenarios/edge_rows.hpp"
#include "tests/scenarios/job.hpp"

namespace {

using scenarios::Position;

// Soft: what it rings is then many steps, of which rounding to steps excites half a one.
constexpr double mode_hertz = 12, mode_damping = 0.1;

// Two corners while E prints, Z moves between them.
std::string gcode_with(const std::string& settings) {
  return "M104 S200\nG28\nM109 S200\n" + settings +
         "\nG1 Z5 F1200\nG1 X20 Y20 F9000\nG4 P1000\nM83\nG1 X120 Y20 E4 F9000\n"
         "G1 X120 Y120 E4\nM400\n"
         "G1 Z6 F1200\nG1 X70 Y120 E2 F9000\nG1 X70 Y20 E4\nM400\nM114\nM84\n";
}

struct Corner {
  double ringing{};  // steps, as soon as X stands for good on its way along Y
  Position steps{};  // from the first edge to the last
  std::string counts;  // as M114 reports them
};

// From 20 to 120 mm at 80 steps/mm.
constexpr std::int64_t corner_steps = 8000;
// X stands behind a corner where its edges are further apart than this.
constexpr double standing_seconds = 0.2;

Corner print_with(const std::string& settings) {
  const scenarios::Print print = scenarios::print_text(
      gcode_with(settings),
      {"--warm", "--machine", PROJECT_DIRECTORY "/firmware/machines/bed_slinger.toml"});
  EXPECT_EQ(print.report["verdict"], "good") << print.job.output;
  EXPECT_EQ(print.report["queue"]["underruns"], 0);
  EXPECT_FALSE(print.said("not fitted"));
  const double clock_hz = print.report["clock_hz"].get<double>();
  const scenarios::Edges edges = scenarios::read_edges(print.edges.string());
  Corner corner;
  plants::Vibration mode(mode_hertz, mode_damping);
  std::int64_t x = edges.start[0], x_of_last_stand = x;
  double last = 0;
  mode.move_to(0, static_cast<double>(x));
  for (const scenarios::Instant& instant : edges.instants) {
    for (std::size_t axis = 0; axis < scenarios::axes; ++axis) {
      corner.steps[axis] += instant.step[axis];
    }
    if (instant.step[0] == 0) continue;
    const double now = static_cast<double>(instant.cycle) / clock_hz;
    if (now - last > standing_seconds) {
      if (x - x_of_last_stand == corner_steps) corner.ringing = mode.amplitude();
      x_of_last_stand = x;
    }
    x += instant.step[0];
    mode.move_to(now, static_cast<double>(x));
    last = now;
  }
  for (const auto& message : print.report["messages"]) {
    const auto text = message["text"].get<std::string>();
    if (const auto place = text.find("Count"); place != std::string::npos) {
      corner.counts = text.substr(place);
    }
  }
  return corner;
}

class Resonance : public testing::Test {
 protected:
  static const Corner& unshaped() {
    static const Corner corner = print_with("M593 F0");
    return corner;
  }
};

TEST_F(Resonance, falls_to_a_twentieth_behind_a_corner_with_the_same_steps) {
  EXPECT_GT(unshaped().ringing, 5);
  for (const char* shaper : {"zv", "zvd", "mzv", "ei", "2hump_ei"}) {
    const Corner shaped =
        print_with(fmt::format("M593 F{} D{} P\"{}\"", mode_hertz, mode_damping, shaper));
    const double left = shaped.ringing / unshaped().ringing;
    fmt::print("{}: {:.2f} steps of {:.2f} left, {:.2f} %\n", shaper, shaped.ringing,
               unshaped().ringing, 100 * left);
    EXPECT_LE(left, 0.05) << shaper;
    EXPECT_EQ(shaped.steps, unshaped().steps);
    EXPECT_EQ(shaped.counts, unshaped().counts);
  }
}

// The measurement can fail: with a shaper for another frequency.
TEST_F(Resonance, stays_with_a_wrong_frequency) {
  const Corner shaped = print_with("M593 F55 D0.1 P\"zv\"");
  EXPECT_GT(shaped.ringing, 0.1 * unshaped().ringing);
}

TEST_F(Resonance, leaves_the_steps_of_all_axes_as_they_are_with_linear_advance) {
  const Corner advanced = print_with("M593 F12 D0.1 P\"mzv\"\nM900 K0.08");
  EXPECT_EQ(advanced.steps, unshaped().steps);
  EXPECT_EQ(advanced.counts, unshaped().counts);
  EXPECT_FALSE(advanced.counts.empty());
}

}  // namespace
