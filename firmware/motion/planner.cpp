// SPDX-License-Identifier: Apache-2.0
// Appending lines, look-ahead over the ring, and handing lines over.
#include "motion/planner.hpp"

#include <algorithm>

#include "motion/junction.hpp"
#include "motion/kinematics/path_limits.hpp"
#include "motion/line_start.hpp"
#include "motion/s_curve.hpp"
#include "motion/steps.hpp"
#include "units/event_bound.hpp"
#include "units/loop_bound.hpp"

namespace motion {

namespace {

// Rounded, but not to 0 where a step is due: a displacement with steps has a length.
units::Nanometers distance_between(const units::Position& from, const units::Position& to,
                                   std::int64_t steps) {
  constexpr std::int32_t half = units::Position::femtometers_per_nanometer / 2;
  const std::int32_t femtometers = to.femtometers() - from.femtometers();
  units::Nanometers distance = to.whole() - from.whole();
  if (femtometers >= half) distance += units::Nanometers(1);
  if (femtometers < -half) distance -= units::Nanometers(1);
  if (distance != units::Nanometers() || steps == 0) return distance;
  return units::Nanometers(steps < 0 ? -1 : 1);
}

bool is_nowhere(const units::PerAxis<units::Nanometers>& distance) {
  units::LoopBound<units::axis_count> axes;
  for (const units::Nanometers& each : distance) {
    axes.next();
    if (each != units::Nanometers()) return false;
  }
  return true;
}

}  // namespace

std::expected<void, Fault> Planner::append(const LineMove& move, units::Microseconds now) {
  if (move.feedrate < units::MicrometersPerSecond(1)) {
    return std::unexpected(Fault::feedrate_out_of_range);
  }
  if (!are_in_range(move.target)) return std::unexpected(Fault::target_out_of_range);
  if (!has_room()) return std::unexpected(Fault::queue_full);
  const bool direct = kinematics_.homes_motors() && move.of_motors;
  if (!direct && !kinematics_.reaches(move.target)) {
    return std::unexpected(Fault::target_out_of_reach);
  }
  const auto& motors = direct ? move.target : kinematics_.motors_of(move.target);
  units::PerAxis<units::Position> from_motors;
  if (direct) from_motors = motor_position();
  const units::PerAxis<units::Position>& from = direct ? from_motors : line_end_;

  constexpr std::int64_t most_steps = 0x7FFF'FFFF;
  Displacement displacement;
  units::PerAxis<StepPosition> ends;
  units::AxisSet others;  // than where the last line ended
  bool moves = false;
  units::LoopBound<units::axis_count, 1> motors_to_move;
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    motors_to_move.next();
    if (!direct && !moves_motor(i, move.target)) {
      displacement.residual[i] = residual_[i] + residual_[i];
      if (kinematics_.identity()) continue;
      displacement.distance[i] = distance_between(from[i], move.target[i], 0);
      continue;
    }
    others.insert(static_cast<units::Axis>(i));
    const StepPosition end = steps_at(motors[i], limits().axes[i].steps_per_meter);
    const std::int64_t way = end.steps - position_steps_[i];
    const std::int64_t steps = takes_up_backlash() ? way + backlash_->steps_before(i, way) : way;
    if (steps < -most_steps || steps > most_steps) return std::unexpected(Fault::line_too_long);
    displacement.distance[i] =
        distance_between(from[i], move.target[i], kinematics_.identity() ? way : 0);
    // It is a way of the motor, within its limits.
    if (takes_up_backlash()) displacement.distance[i] += backlash_->length_of(i, steps - way);
    displacement.steps[i] = static_cast<std::int32_t>(steps);
    displacement.residual[i] = residual_[i] + end.residual;
    ends[i] = end;
    moves |= steps != 0;
  }
  // Homing sets the position at its end; the place on its way is nothing to calculate.
  if (!direct) target_ = move.target;
  if (!moves) return {};
  if (!kinematics_.identity() && is_nowhere(displacement.distance)) {
    displacement.distance[0] = units::Nanometers(1);
  }
  append(displacement, move, now);
  units::LoopBound<units::axis_count, 2> motors_moved;
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    motors_moved.next();
    if (!others.contains(static_cast<units::Axis>(i))) continue;
    if (kinematics_.identity()) line_end_[i] = move.target[i];
    if (takes_up_backlash()) backlash_->turn(i, ends[i].steps - position_steps_[i]);
    position_steps_[i] = ends[i].steps;
    residual_[i] = ends[i].residual;
  }
  if (!kinematics_.identity()) line_end_ = target_;
  return {};
}

// An axis with its own motor needs none of the others' targets. The other motors stand still where
// the tool does: they may have been set to steps whose place is rounded.
bool Planner::moves_motor(std::size_t motor, const units::PerAxis<units::Position>& target) const {
  const auto differs = [&](std::size_t i) { return target[i] != line_end_[i]; };
  if (kinematics_.identity() || motor >= kinematics::spatial_axes) return differs(motor);
  return differs(0) || differs(1) || differs(2);
}

void Planner::append(const Displacement& displacement, const LineMove& move,
                     units::Microseconds now) {
  supply_.line_came(now);
  Line& added = lines_[(first_ + count_) % capacity];
  Course course =
      geometry_.make_line(displacement, std::min(move.feedrate, max_speed),
                          std::max(timing_.least_line_time, supply_.least_time(stock(now))), added);
  if (!kinematics_.straight()) kinematics::limit_to_motors(limits(), displacement, added, course);
  added.start = line_start(added.steps, course.ticks, displacement.residual);
  added.stop_mask = move.stop_mask;
  if (count_ == 0) {
    added.max_entry = energy_from_rest(course, limits());
    added.entry = added.max_entry;
    waiting_since_ = now;
  } else {
    added.max_entry = junction_energy(last_course_, course, limits());
    units::happens<units::Event::lines_joined>();
  }
  last_course_ = course;
  planned_time_ += added.least_time();
  ++count_;
  if (++fresh_ == most_fresh) look_ahead();
}

Stock Planner::stock(units::Microseconds now) const {
  return {.lines = count_,
          .time = planned_time_ + std::max(busy_until_ - now, units::Microseconds()),
          .resting = resting_};
}

// The ring ends at rest. Backwards from there, no line may begin faster than it can brake for the
// next one; then forwards, none faster than the line before can have accelerated to. A line that
// begins as fast as its junction or its predecessor permit cannot gain from further lines, nor can
// those before it.
//
// It goes over as many lines as braking takes, so it is done for some lines at once, and in any
// case before one is handed over whose end a fresh line may still make faster.
void Planner::look_ahead() {
  units::happens<units::Event::looked_ahead>(count_);
  units::happens<units::Event::settled>(count_);
  std::size_t changed = count_ - 1;
  Line* here = &line(changed);
  SpecificEnergy exit{};
  units::LoopBound<capacity> backwards;
  for (; changed > settled_; --changed) {
    backwards.next();
    units::happens<units::Event::line_looked_at>(changed);
    const SpecificEnergy entry = std::min(here->max_entry, exit + here->work);
    if (entry == here->entry && changed + fresh_ < count_) break;
    here->entry = entry;
    exit = entry;
    here = (here == lines_.data() ? lines_.data() + capacity : here) - 1;
  }
  // From rest neither may the first one begin faster; otherwise its entry is the exit of a line
  // that has been handed over.
  if (resting_ && changed == 0) here->entry = std::min(here->max_entry, exit + here->work);
  units::LoopBound<capacity, 1> forwards;
  for (std::size_t i = changed + 1; i < count_; ++i) {
    forwards.next();
    units::happens<units::Event::line_looked_at>(i);
    const SpecificEnergy reachable = here->entry + here->work;
    here = here + 1 == lines_.data() + capacity ? lines_.data() : here + 1;
    if (here->entry >= reachable) {
      here->entry = reachable;
      settled_ = i;
    } else if (here->entry == here->max_entry) {
      settled_ = i;
    }
  }
  fresh_ = 0;
}

std::optional<Segment> Planner::next_segment(units::Microseconds now) {
  if (next_phase_ == profile_.count) {
    if (!may_hand_over(now)) return std::nullopt;
    hand_over_first(now);
  }
  const Phase& phase = profile_.phases[next_phase_];
  // Made where it is returned, not copied there.
  std::optional<Segment> made;
  Segment& segment = made.emplace();
  segment.steps = steps_;
  segment.start = start_;
  segment.line_ticks = profile_.ticks;
  segment.ticks = phase.ticks;
  segment.continues_line = next_phase_ > 0;
  segment.rate = phase.rate;
  segment.acceleration = phase.acceleration;
  segment.stop_mask = stop_mask_;
  if (!s_curve_in_image || phase.apex == 0 || !set_half(phase, segment)) {
    ++next_phase_;
    segment.ends_motion = resting_ && next_phase_ == profile_.count;
  }
  return made;
}

// The next half of a ramp of third order, which is a phase of two segments. True if it was the
// first one.
bool Planner::set_half(const Phase& phase, Segment& segment) {
  const std::uint64_t last_rate = phase.rate + static_cast<std::uint64_t>(phase.acceleration);
  const SCurve curve(phase.ticks, phase.rate, last_rate, phase.apex);
  if (second_half_) segment.continues_line = true;
  curve.set_half(second_half_, segment);
  second_half_ = !second_half_;
  return second_half_;
}

bool Planner::may_hand_over(units::Microseconds now) const {
  // Called many times for each line, and mostly decided here.
  const units::Microseconds ahead = busy_until_ - now;
  if (count_ == 0 || ahead >= horizon) return false;
  // No more than is left to plan with: later lines may yet make the ring's end faster.
  if (ahead >= std::max(planned_time_, timing_.longest_pass)) return false;
  if (!resting_ || flush_) return true;
  return !has_room() || planned_time_ >= start_delay || now - waiting_since_ >= start_delay;
}

void Planner::hand_over_first(units::Microseconds now) {
  units::happens<units::Event::line_begun>(count_);
  if (fresh_ != 0 && settled_ == 0) look_ahead();
  const Line& first = line(0);
  make_profile(first, count_ > 1 ? line(1).entry : SpecificEnergy(), geometry_.clock(),
               limits().min_cruise_percent, s_curve_in_image && limits().s_curve, profile_);
  steps_ = first.steps;
  start_ = first.start;
  stop_mask_ = first.stop_mask;
  next_phase_ = 0;
  busy_until_ = std::max(busy_until_, now) + profile_.time;
  planned_time_ -= first.least_time();
  first_ = (first_ + 1) % capacity;
  --count_;
  settled_ = settled_ > 0 ? settled_ - 1 : 0;
  resting_ = count_ == 0;
  if (resting_) flush_ = false;
}

}  // namespace motion
