// SPDX-License-Identifier: Apache-2.0
// The planner at rest: settings, positions, and how it forgets. Apart from what runs for each line,
// which is compiled for speed.
#include "motion/planner.hpp"
#include "motion/steps.hpp"

namespace motion {

Planner::Planner(const Limits& limits, const StepTiming& timing)
    : timing_(timing), geometry_(limits, timing) {}

void Planner::set_limits(const Limits& limits) { geometry_ = Geometry(limits, timing_); }

void Planner::clear() {
  count_ = 0;
  settled_ = 0;
  resting_ = true;
  flush_ = false;
  planned_time_ = {};
  busy_until_ = {};
  profile_.count = 0;
  next_phase_ = 0;
}

void Planner::set_position(const units::PerAxis<units::Position>& position) {
  target_ = line_end_ = position;
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    const StepPosition here = steps_at(position[i], limits().axes[i].steps_per_meter);
    position_steps_[i] = here.steps;
    residual_[i] = here.residual;
  }
}

void Planner::set_position_steps(const units::PerAxis<std::int64_t>& steps) {
  position_steps_ = steps;
  residual_ = {};
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    line_end_[i] = position_of(steps[i], limits().axes[i].steps_per_meter);
  }
  target_ = line_end_;
}

}  // namespace motion
