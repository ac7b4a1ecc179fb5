// SPDX-License-Identifier: Apache-2.0
// Limits and backlash, and where planner and counters say that the axes are.
#include "application/motion_task.hpp"

namespace application {
namespace {

using units::index_of;

constexpr std::array all_axes{units::Axis::x, units::Axis::y, units::Axis::z, units::Axis::e};

}  // namespace

void MotionTask::set_limits(const motion::Limits& limits) {
  planner_.set_limits(limits);
  pace_.set_limits(limits);
  if (shapes()) shaping_->set_limits(limits);
}

void MotionTask::set_steps_per_meter(const motion::Limits& limits) {
  const auto positions = planner_.position();
  located_ = {};
  set_limits(limits);
  set_position(positions);
}

void MotionTask::change_geometry(const motion::kinematics::Chosen& kinematics,
                                 const motion::Limits& limits) {
  if (levels()) stop_levelling();
  planner_.set_kinematics(kinematics);
  homed_ = {};
  set_steps_per_meter(limits);
}

void MotionTask::set_backlash(const motion::BacklashSettings& settings) {
  planner_.backlash().configure(settings, limits());
  set_position(planner_.position());
}

units::PerAxis<units::Steps> MotionTask::steps() {
  units::PerAxis<units::Steps> counted;
  const auto positions = step_generator_.snapshot().positions;
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    counted[i] = units::Steps(positions[i] - lead(i));
  }
  return counted;
}

// At rest, when the hardware accepts writes to its counters.
void MotionTask::set_position(const units::PerAxis<units::Position>& positions) {
  planner_.set_position(positions);
  for (const units::Axis axis : all_axes) {
    const std::size_t motor = index_of(axis);
    const auto steps = static_cast<std::int32_t>(planner_.position_steps()[motor] + lead(motor));
    static_cast<void>(step_generator_.set_position(axis, steps));
  }
}

}  // namespace application
