// SPDX-License-Identifier: Apache-2.0
// Where end stops and tool are by the motors' steps.
#include <algorithm>
#include <cmath>

#include "tools/planning/motion_model.hpp"
#include "units/axes.hpp"

namespace planning {

namespace {

constexpr std::size_t x = units::index_of(units::Axis::x), y = units::index_of(units::Axis::y),
                      z = units::index_of(units::Axis::z);

}  // namespace

void MotionModel::place_end_stops(const motion::Limits& limits) {
  for (std::size_t i = 0; i < axis_count; ++i) {
    const auto& homing = limits.axes[i].homing;
    if (!homing) continue;
    end_stop_[i] = 1u << homing->end_stop;
    const std::int64_t sign = homing->towards_positive ? 1 : -1;
    towards_[i][i] = sign;
    if (kinematics_.crosses_xy() && i == x) towards_[x] = {sign, sign, 0, 0, 0};
    if (kinematics_.crosses_xy() && i == y) towards_[y] = {sign, -sign, 0, 0, 0};
    const std::int64_t motors = std::abs(towards_[i][0]) + std::abs(towards_[i][1]);
    distance_[i] = std::llround(start_mm * steps_per_mm_[i]) * std::max<std::int64_t>(motors, 1);
  }
}

std::int64_t MotionModel::approach_of(std::size_t axis,
                                      const std::array<std::int64_t, motor_count>& steps) const {
  std::int64_t approach = 0;
  for (std::size_t i = 0; i < motor_count; ++i) approach += towards_[axis][i] * steps[i];
  return approach;
}

// Of the tool, by the counters.
std::array<double, 3> MotionModel::place_mm() const {
  std::array<double, 3> place{};
  motion::kinematics::Place motors;
  for (const std::size_t i : {x, y, z}) {
    place[i] = position_[i] / steps_per_mm_[i];
    motors[i] = units::Nanometers(std::llround(place[i] * 1e6));
  }
  if (kinematics_.identity()) return place;
  const motion::kinematics::Place tool = kinematics_.place_of(motors);
  for (const std::size_t i : {x, y, z}) {
    place[i] = static_cast<double>(tool[i].nearest().count()) * 1e-6;
  }
  return place;
}

}  // namespace planning
