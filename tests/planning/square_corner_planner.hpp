// SPDX-License-Identifier: Apache-2.0
// The time of a print by the rules in Klipper's documentation of its planner ("Kinematics":
// trapezoids, look-ahead, junction speed by the square corner velocity), in floating point and over
// the whole file. It shares nothing with the firmware.
#pragma once

#include <array>
#include <string_view>
#include <vector>

namespace planning {

struct SquareCornerLimits {
  double speed = 300, acceleration = 3000, square_corner_speed = 5;
  double z_speed = 20, z_acceleration = 500;
  double filament_speed = 80, filament_acceleration = 800;  // of E alone
  double filament_corner_speed = 1;
};

class SquareCornerPlanner {
 public:
  explicit SquareCornerPlanner(const SquareCornerLimits& limits) : limits_(limits) {}

  // G0, G1, G90, G91, G92, M82, M83; the others do not move.
  void take(std::string_view line);
  // Of all moves, from rest to rest.
  double seconds();

 private:
  using Vector = std::array<double, 4>;

  struct Move {
    Vector direction{};  // per mm of path
    double length{}, acceleration{};
    bool travels{};  // X, Y or Z moves
    // Squares of speeds: the highest at the start and after it, and the planned one at the start.
    double highest_start{}, highest{}, start{};
  };

  void append(const Vector& target);
  double corner_square(const Move& before, const Move& after) const;

  SquareCornerLimits limits_;
  Vector position_{};
  bool relative_ = false, relative_e_ = false;
  double speed_ = 25;
  std::vector<Move> moves_;
};

}  // namespace planning
