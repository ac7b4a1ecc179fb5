// SPDX-License-Identifier: Apache-2.0
// The plan of a print, as plain values.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace planning {

inline constexpr std::size_t axis_count = 4;
// x y z e, and e of a second extruder.
inline constexpr std::size_t motor_count = axis_count + 1;

struct AxisPlan {
  std::uint64_t steps_forward{};
  std::uint64_t steps_backward{};
  double max_step_rate_hz{};
  double max_speed_mm_per_s{};
  double max_acceleration_mm_per_s2{};
};

// From its first extruding line to that of the next one.
struct Layer {
  double z_mm{};
  double begin_seconds{};
  double seconds{};
};

struct RefusedLine {
  std::size_t file_line{};
  std::string text;
  std::string reason;
};

struct Plan {
  std::string machine;
  double seconds{};  // from the first line to the end of the last move; without heating
  double moving_seconds{};
  double first_move_seconds{};  // its begin
  std::uint64_t lines{};  // of the file
  std::uint64_t moves{};  // lines that the step generator executes, each chord of an arc
  std::uint64_t underruns{};
  double filament_mm{};  // of all tools
  std::size_t tools{1};
  std::array<double, 2> filament_of_tool_mm{};
  std::array<AxisPlan, motor_count> axes{};
  std::vector<Layer> layers;
  std::vector<RefusedLine> refused;
  std::string fault;  // that ends the print, or empty
};

}  // namespace planning
