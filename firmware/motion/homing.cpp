// SPDX-License-Identifier: Apache-2.0
// The states of homing one axis after another.
#include "motion/homing.hpp"

#include <algorithm>

#include "machine/kinematics.hpp"

#include "units/loop_bound.hpp"

namespace motion {

namespace {

using Kind = HomingRequest::Kind;

}  // namespace

void Homing::start(units::AxisSet axes, const Limits& limits, bool together) {
  limits_ = limits;
  remaining_ = axes;
  axis_ = units::Axis::x;
  state_ = together ? State::begin_together : State::begin_axis;
}

HomingRequest Homing::update(const HomingObservation& observation) {
  if (state_ == State::idle || !observation.at_rest) return {};
  switch (state_) {
    case State::idle:
      return {};
    case State::begin_together:
      if constexpr (kinematics::Chosen::may_home_motors) return begin_together();
      [[fallthrough]];
    case State::approach_together:
      if (kinematics::Chosen::may_home_motors && !observation.stopped) {
        return fail(Fault::end_stop_not_found);
      }
      [[fallthrough]];
    case State::begin_axis:
      return begin_axis(observation);
    case State::release:
      if (pressed(observation)) return fail(Fault::end_stop_stuck);
      // It has opened on the way back.
      return approach(parameters().back_off * 2);
    case State::approach:
      if (!observation.stopped) return fail(Fault::end_stop_not_found);
      return move(State::back_off, -towards_end_stop(parameters().back_off),
                  parameters().fast_speed, 0);
    case State::back_off:
      if (pressed(observation)) return fail(Fault::end_stop_stuck);
      return move(State::approach_slowly, towards_end_stop(parameters().back_off * 2),
                  parameters().slow_speed, stop_mask());
    case State::approach_slowly:
      if (!observation.stopped) return fail(Fault::end_stop_not_found);
      remaining_.remove(axis_);
      state_ = State::begin_axis;
      return {.kind = Kind::set_position, .axis = axis_, .position = parameters().position};
  }
  return {};
}

HomingRequest Homing::begin_together() {
  units::Nanometers distance;
  units::MicrometersPerSecond speed = parameters().fast_speed;
  std::uint32_t mask = 0;
  units::LoopBound<units::axis_count, 1> axes;
  for (const AxisLimits& axis : limits_.axes) {
    axes.next();
    if (!axis.homing) continue;
    distance = std::max(distance, axis.travel + axis.homing->back_off);
    speed = std::min(speed, axis.homing->fast_speed);
    mask |= 1u << axis.homing->end_stop;
  }
  HomingRequest request = move(State::approach_together, towards_end_stop(distance), speed,
                               static_cast<std::uint8_t>(mask));
  request.move.together = true;
  return request;
}

HomingRequest Homing::begin_axis(const HomingObservation& observation) {
  units::LoopBound<units::axis_count> axes;
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    axes.next();
    axis_ = static_cast<units::Axis>(i);
    if (!remaining_.contains(axis_) || !limits_.of(axis_).homing) continue;
    if (!pressed(observation)) return approach(limits_.of(axis_).travel + parameters().back_off);
    return move(State::release, -towards_end_stop(parameters().back_off), parameters().slow_speed,
                0);
  }
  state_ = State::idle;
  return {.kind = Kind::finished};
}

HomingRequest Homing::approach(units::Nanometers distance) {
  return move(State::approach, towards_end_stop(distance), parameters().fast_speed, stop_mask());
}

HomingRequest Homing::move(State next, units::Nanometers distance,
                           units::MicrometersPerSecond speed, std::uint8_t mask) {
  state_ = next;
  return {.kind = Kind::move,
          .move = {.axis = axis_, .distance = distance, .speed = speed, .stop_mask = mask},
          .axis = axis_};
}

HomingRequest Homing::fail(Fault fault) {
  state_ = State::idle;
  return {.kind = Kind::fault, .axis = axis_, .fault = fault};
}

const HomingParameters& Homing::parameters() const { return *limits_.of(axis_).homing; }

std::uint8_t Homing::stop_mask() const {
  return static_cast<std::uint8_t>(1u << parameters().end_stop);
}

bool Homing::pressed(const HomingObservation& observation) const {
  return (observation.end_stops & stop_mask()) != 0;
}

units::Nanometers Homing::towards_end_stop(units::Nanometers distance) const {
  return parameters().towards_positive ? distance : -distance;
}

}  // namespace motion
