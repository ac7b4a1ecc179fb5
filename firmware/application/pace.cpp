// SPDX-License-Identifier: Apache-2.0
// The override of the step generator, and what the planner must know of it.
#include "application/pace.hpp"

namespace application {
namespace {

constexpr int time_fraction_bits = 17;

}  // namespace

void Pace::set_limits(const motion::Limits& limits) {
  if (step_generator_.stretches_time()) slope_.set_limits(limits);
}

void Pace::note_rest() {
  if (step_generator_.stretches_time()) slope_.note_rest();
}

void Pace::note_line(units::MicrometersPerSecond feedrate) {
  if (!step_generator_.stretches_time()) return;
  if (const auto slope = slope_.note_line(feedrate)) step_generator_.set_slopes(*slope, *slope);
}

void Pace::set_stretch(Stretch stretch) {
  stretch_ = stretch;
  set_scale();
}

void Pace::hold(bool held) {
  held_ = held;
  set_scale();
}

void Pace::set_homing(bool homing) {
  if (homing == homing_) return;
  homing_ = homing;
  set_scale();
}

void Pace::set_scale() {
  target_ = held_ ? 0 : homing_ ? one : stretch_;
  step_generator_.set_override(target_);
}

units::Microseconds Pace::update(units::Microseconds now, bool moving) {
  const std::int64_t passed = (now - last_).count();
  last_ = now;
  // A scale that changes counts with the mean of its ends. At rest real time passes.
  const std::uint32_t before = scale_;
  if (target_ != one || scale_ != one) scale_ = step_generator_.scale();
  time_ += passed * (moving ? before + scale_ : 2 * one);
  return time();
}

units::Microseconds Pace::time() const { return units::Microseconds(time_ >> time_fraction_bits); }

}  // namespace application
