// SPDX-License-Identifier: Apache-2.0
// G28: what homing requests becomes moves, and their ends become positions.
#include <algorithm>

#include "application/motion_task.hpp"
#include "units/event_bound.hpp"

namespace application {
namespace {

using units::index_of;

constexpr std::array all_axes{units::Axis::x, units::Axis::y, units::Axis::z, units::Axis::e};

units::PerAxis<units::Position> with_axis(units::PerAxis<units::Position> positions,
                                          units::Axis axis, units::Nanometers position) {
  positions[index_of(axis)] = position;
  return positions;
}

}  // namespace

void MotionTask::start_homing(units::AxisSet axes) {
  homing_fault_.reset();
  if (levels()) stop_levelling();
  if (kinematics().homes_motors()) {
    axes = units::AxisSet::all();
    located_ = {};
  }
  motion::Limits limits = planner_.limits();
  for (const units::Axis axis : all_axes) {
    if (!axes.contains(axis) || !limits.of(axis).homing) continue;
    limits.of(axis).travel = located_.contains(axis) ? distance_to_end_stop(axis)
                                                     : machine_.homing_search[index_of(axis)];
    located_.remove(axis);
  }
  homing_.start(axes, limits, kinematics().homes_motors());
}

units::Nanometers MotionTask::distance_to_end_stop(units::Axis axis) const {
  const motion::HomingParameters& homing = *limits().of(axis).homing;
  const units::Nanometers above = planner_.position()[index_of(axis)].nearest() - homing.position;
  return std::max(homing.towards_positive ? -above : above, units::Nanometers(0));
}

void MotionTask::lead_homing(units::Milliseconds now) {
  if (!step_generator_.idle() || !plan_is_done() || !line_is_whole() || stopping_) return;
  // It may be at rest because of a stop after the check in settle_stop().
  if (step_generator_.stopped() || now < rings_until_) return;
  // Its lines begin and end at rest.
  units::EventBound<units::Event::line_looked_at, 0> ahead;
  units::EventBound<units::Event::lines_joined, 0> joined;
  if (probing()) return lead_probing();
  carry_out(homing_.update(
      {.at_rest = true, .stopped = stopped_by_end_stop_, .end_stops = end_stops_.triggered()}));
}

void MotionTask::carry_out(const motion::HomingRequest& request) {
  using Kind = motion::HomingRequest::Kind;
  switch (request.kind) {
    case Kind::nothing:
      return;
    case Kind::finished:
      if (kinematics().homes_motors()) finish_homing_of_motors();
      return;
    case Kind::move: {
      stopped_by_end_stop_ = false;
      const auto accepted = append(homing_move(request.move));
      if (!accepted) {
        homing_.cancel();
        homing_fault_ = accepted.error();
        homing_axis_ = request.move.axis;
      }
      flush();
      return;
    }
    case Kind::set_position:
      if (kinematics().homes_motors()) return pass_end_stop(request);
      set_position(with_axis(planner_.position(), request.axis, request.position));
      ++position_jumps_;
      homed_.insert(request.axis);
      located_.insert(request.axis);
      return;
    case Kind::fault:
      homing_fault_ = request.fault;
      homing_axis_ = request.axis;
      return;
  }
}

motion::LineMove MotionTask::homing_move(const motion::HomingMove& request) const {
  const bool motors = kinematics().homes_motors();
  motion::LineMove move{.target = motors ? planner_.motor_position() : planner_.position(),
                        .feedrate = request.speed,
                        .stop_mask = request.stop_mask,
                        .of_motors = motors};
  if (!motors || !request.together) {
    move.target[index_of(request.axis)] += request.distance;
    return move;
  }
  for (std::size_t i = 0; i < motion::kinematics::spatial_axes; ++i) {
    move.target[i] += request.distance;
  }
  // Three motors at this speed: along the line through all of them by sqrt(3).
  move.feedrate = units::MicrometersPerSecond(static_cast<std::int32_t>(std::min<std::int64_t>(
      std::int64_t{request.speed.count()} * 1732 / 1000 + 1, motion::max_speed.count())));
  return move;
}

// A motor at its end stop goes on to where it is at home, once it stands.
void MotionTask::pass_end_stop(const motion::HomingRequest& request) {
  const std::size_t motor = index_of(request.axis);
  const units::Nanometers behind = kinematics().home().behind_end_stop[motor];
  if (behind == units::Nanometers(0)) return;
  motion::LineMove move{.target = planner_.motor_position(),
                        .feedrate = limits().axes[motor].homing->slow_speed,
                        .of_motors = true};
  move.target[motor] += behind;
  const auto accepted = append(move);
  if (!accepted) {
    homing_.cancel();
    homing_fault_ = accepted.error();
    homing_axis_ = request.axis;
  }
  flush();
}

// All of them are at home.
void MotionTask::finish_homing_of_motors() {
  units::PerAxis<units::Position> place = kinematics().home().tool;
  constexpr std::size_t extruder = index_of(units::Axis::e);
  place[extruder] = planner_.position()[extruder];
  set_position(place);
  ++position_jumps_;
  for (const units::Axis axis : all_axes) {
    if (!limits().of(axis).homing) continue;
    homed_.insert(axis);
    located_.insert(axis);
  }
}

}  // namespace application
