// SPDX-License-Identifier: Apache-2.0
// Ramps of third order on the whole chip: the acceleration of each axis, and how fast that changes,
// from its step edges; and those of the same file without such ramps.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "directories.hpp"
#include "tests/scenarios/edge_rows.hpp"
#include "tests/scenarios/job.hpp"
#include "tools/files/file_text.hpp"

namespace {

using scenarios::Position;

// Lines of X, of Y, of both, and of Z, from and to rest: so little jerk that an axis begins with
// the speed in the middle of its first step.
constexpr const char* gcode =
    "M205 X0.1 Y0.1 Z0.1\nM204 T1000\nG91\nG1 X60 F9000\nG1 Y60\nG1 X-60 Y-60\nG1 Z4 F600\n"
    "M400\nM114\nM84\n";
constexpr std::array<double, 3> steps_per_mm{80, 80, 2560};
constexpr double path_acceleration = 1000, z_acceleration = 500;  // mm/s^2

// The time between places that are compared: many steps, and short against a ramp of 300 ms.
constexpr double interval = 20e-3, stride = 2e-3;
// So long before the first step from rest an axis begins to move.
constexpr double first_step = 5e-3;

// Of one axis, between its edges in equal parts.
class Places {
 public:
  Places(const scenarios::Edges& edges, std::size_t axis, double clock_hz) {
    double place = 0;
    for (const scenarios::Instant& instant : edges.instants) {
      if (instant.step[axis] == 0) continue;
      place += static_cast<double>(instant.step[axis]) / steps_per_mm[axis];
      times_.push_back(static_cast<double>(instant.cycle) / clock_hz);
      places_.push_back(place);
    }
  }

  double begin() const { return times_.front(); }
  double end() const { return times_.back(); }
  double at(double time) const {
    const auto next = std::ranges::lower_bound(times_, time);
    if (next == times_.begin()) return 0;
    if (next == times_.end()) return places_.back();
    const auto i = static_cast<std::size_t>(next - times_.begin());
    const double moving = std::min(times_[i] - times_[i - 1], first_step);
    const double part = std::max(1 - (times_[i] - time) / moving, 0.0);
    return places_[i - 1] + part * (places_[i] - places_[i - 1]);
  }
  double acceleration(double time) const {
    return (at(time + interval) - 2 * at(time) + at(time - interval)) / (interval * interval);
  }

 private:
  std::vector<double> times_, places_;
};

struct Measured {
  std::array<double, 3> acceleration{}, jerk{};  // the highest
  Position steps{};
  std::string counts;  // as M114 reports them
};

Measured print_with(bool s_curve) {
  std::string machine = files::text_of(PROJECT_DIRECTORY "/firmware/machines/prusa_mendel.toml");
  const std::string table = "\n[motion]\n", kinematics = "kinematics = \"cartesian\"\n";
  machine.insert(machine.find(table) + table.size(),
                 fmt::format("s_curve_acceleration = {}\n", s_curve));
  machine.insert(machine.find(kinematics), "memory_kib = 128\n");
  const auto file = scenarios::scratch_folder() / "machine.toml";
  scenarios::write_file(file, machine);
  const auto print = scenarios::print_text(gcode, {"--machine", file.string()});
  EXPECT_EQ(print.report["result"], "completed") << print.job.output;
  EXPECT_EQ(print.report["queue"]["underruns"], 0);
  Measured measured;
  const scenarios::Edges edges = scenarios::read_edges(print.edges.string());
  for (const scenarios::Instant& instant : edges.instants) {
    for (std::size_t i = 0; i < scenarios::axes; ++i) measured.steps[i] += instant.step[i];
  }
  for (std::size_t i = 0; i < steps_per_mm.size(); ++i) {
    const Places places(edges, i, print.report["clock_hz"].get<double>());
    for (double time = places.begin(); time <= places.end(); time += stride) {
      const double here = places.acceleration(time);
      const double jerk = (places.acceleration(time + interval) - here) / interval;
      measured.acceleration[i] = std::max(measured.acceleration[i], std::abs(here));
      measured.jerk[i] = std::max(measured.jerk[i], std::abs(jerk));
    }
  }
  for (const auto& message : print.report["messages"]) {
    const auto text = message["text"].get<std::string>();
    if (const auto place = text.find("Count"); place != std::string::npos) {
      measured.counts = text.substr(place);
    }
  }
  fmt::print("{}: acceleration {:.0f} mm/s^2, jerk {:.0f} mm/s^3\n",
             s_curve ? "third order" : "constant acceleration",
             fmt::join(measured.acceleration, ", "), fmt::join(measured.jerk, ", "));
  return measured;
}

TEST(s_curve, changes_the_acceleration_slowly_within_the_limits_and_makes_the_same_steps) {
  const Measured constant = print_with(false);
  const Measured curve = print_with(true);
  EXPECT_EQ(curve.steps, constant.steps);
  EXPECT_EQ(curve.counts, constant.counts);
  EXPECT_FALSE(curve.counts.empty());
  // Twice the acceleration in the 300 ms of a ramp to 150 mm/s; and at rest the speed in the middle
  // of the first step.
  const double first_speed = std::sqrt(path_acceleration / 2 / steps_per_mm[0]);
  const double jerk = 2 * path_acceleration / 0.3 + first_speed / (interval * interval);
  for (const std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
    EXPECT_LE(curve.acceleration[axis], path_acceleration * 1.02);
    EXPECT_GE(curve.acceleration[axis], path_acceleration * 0.9) << "the limit is used";
    EXPECT_LE(curve.jerk[axis], 1.25 * jerk);
    // All of the acceleration within two intervals.
    EXPECT_GE(constant.jerk[axis], 2 * curve.jerk[axis]);
  }
  EXPECT_LE(curve.acceleration[2], z_acceleration * 1.02);
  EXPECT_GE(curve.acceleration[2], z_acceleration * 0.25);
}

TEST(s_curve, needs_the_step_generator) {
  const auto print = scenarios::print_text(
      "G28\n",
      {"--machine", PROJECT_DIRECTORY "/firmware/machines/core_xy.toml", "--stepping", "software"});
  EXPECT_NE(print.job.status, 0);
  EXPECT_THAT(print.job.output, testing::HasSubstr("motion.s_curve_acceleration"));
}

}  // namespace
