// SPDX-License-Identifier: Apache-2.0
// The path of a print as the step generator makes it, with the command that each part belongs to.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

namespace planning {

// What one line of the step generator has done, in millimetres by the counters of steps.
struct Walk {
  std::array<double, 3> end_mm{};  // X, Y, Z
  double filament_mm{};
};

struct PathPoint {
  float x_mm{}, y_mm{};
  std::uint32_t command{};  // that leads here, counted from 1 as a host sends them
  bool extrudes{};  // on the way here
};

// From its first extruding line to that of the next one; the first has what is before too. Its
// first point is where it begins.
struct PathLayer {
  double z_mm{};
  std::size_t first{};  // its first point
};

struct Path {
  std::array<double, 3> steps_per_mm{};
  std::vector<PathPoint> points;
  std::vector<PathLayer> layers;
};

class PathRecorder {
 public:
  // A point between two others of the same kind is left out where it is no farther from their line.
  static constexpr double tolerance_mm = 0.02;
  // A rising line, as of a vase, begins a layer when it is so much higher.
  static constexpr double rise_mm = 0.2;

  // The command is given to the firmware, and has been taken: so many lines of the step generator
  // are planned then, made or not.
  void begin_command(std::uint32_t command) { command_ = command; }
  void end_command(std::uint64_t lines);
  // The next line is made.
  void add(const Walk& walk);

  Path finish(const std::array<double, 3>& steps_per_mm);

 private:
  std::uint32_t command_of(std::uint64_t line);
  void append(const PathPoint& point);
  bool is_straight_to(const PathPoint& point) const;

  struct Taken {
    std::uint64_t lines{};
    std::uint32_t command{};
  };
  Path path_;
  std::deque<Taken> taken_;  // commands with lines that are not made yet
  std::vector<PathPoint> left_out_;  // between the last two points
  std::array<double, 3> position_{};
  double layer_z_ = 0;
  std::uint64_t lines_ = 0;
  std::uint32_t command_ = 0;
  bool has_layer_ = false;
};

}  // namespace planning
