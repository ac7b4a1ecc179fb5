// SPDX-License-Identifier: Apache-2.0
// The planner at rest: settings, positions, and how it forgets. Apart from what runs for each line,
// which is compiled for speed.
#include "motion/planner.hpp"
#include "motion/s_curve.hpp"
#include "motion/steps.hpp"

namespace motion {

Planner::Planner(const Limits& limits, const StepTiming& timing,
                 const kinematics::Chosen& kinematics)
    : timing_(timing), geometry_(limits, timing), kinematics_(kinematics) {}

void Planner::set_limits(const Limits& limits) {
  geometry_ = Geometry(limits, timing_);
  if (takes_up_backlash()) backlash_->set_limits(limits);
}

void Planner::clear() {
  count_ = 0;
  fresh_ = 0;
  settled_ = 0;
  resting_ = true;
  flush_ = false;
  planned_time_ = {};
  busy_until_ = {};
  profile_.count = 0;
  next_phase_ = 0;
  if (s_curve_in_image) second_half_ = false;
}

void Planner::set_position(const units::PerAxis<units::Position>& position) {
  target_ = line_end_ = position;
  const auto& motors = kinematics_.motors_of(position);
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    const StepPosition here = steps_at(motors[i], limits().axes[i].steps_per_meter);
    position_steps_[i] = here.steps;
    residual_[i] = here.residual;
  }
}

// With all kinematics E is its motor's place.
void Planner::set_extruder_position(const units::Position& position) {
  constexpr std::size_t e = units::index_of(units::Axis::e);
  target_[e] = line_end_[e] = position;
  const StepPosition here = steps_at(position, limits().axes[e].steps_per_meter);
  position_steps_[e] = here.steps;
  residual_[e] = here.residual;
}

units::PerAxis<units::Position> Planner::motor_position() const {
  units::PerAxis<units::Position> motors;
  units::LoopBound<units::axis_count> axes;
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    axes.next();
    motors[i] = position_of(position_steps_[i], limits().axes[i].steps_per_meter);
  }
  return motors;
}

// An axis that is at its step already keeps the part of a step that its place is away from there.
void Planner::set_position_steps(const units::PerAxis<std::int64_t>& steps) {
  const units::PerAxis<std::int64_t> before = position_steps_;
  position_steps_ = steps;
  const kinematics::Place place = kinematics_.place_of(motor_position());
  units::LoopBound<units::axis_count, 1> axes;
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    axes.next();
    const bool is_motor = kinematics_.identity() || i == units::index_of(units::Axis::e);
    if (is_motor && steps[i] == before[i]) continue;
    residual_[i] = {};
    target_[i] = line_end_[i] = place[i];
  }
}

}  // namespace motion
