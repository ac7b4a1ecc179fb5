// SPDX-License-Identifier: Apache-2.0
// The states of probing one place.
#include "motion/probing.hpp"

#include <algorithm>

namespace motion {
namespace {

using units::Nanometers;

constexpr std::size_t z = units::index_of(units::Axis::z);

}  // namespace

std::string_view describe(ProbeFault fault) {
  switch (fault) {
    case ProbeFault::not_triggered:
      return "not triggered down to the deepest place, check the probe and M851 Z";
    case ProbeFault::triggered_early:
      return "triggered before its descent, check the probe and its wiring";
    case ProbeFault::does_not_open:
      return "still triggered after its back-off, check the probe and its wiring";
  }
  return "unknown fault";
}

void Probing::start(const ProbeSettings& settings, Nanometers x, Nanometers y) {
  settings_ = settings;
  x_ = x;
  y_ = y;
  result_.reset();
  fault_.reset();
  state_ = State::lift;
}

std::optional<ProbingMove> Probing::update(const ProbingObservation& observation) {
  units::PerAxis<units::Position> target = observation.place;
  switch (state_) {
    case State::idle:
      return std::nullopt;
    case State::lift:
      target[z] = std::max(target[z], units::Position(settings_.clearance));
      return move(State::travel, target, settings_.fast_speed, false);
    case State::travel:
      if (observation.triggered) return fail(ProbeFault::triggered_early);
      target[0] = x_ - settings_.offset[0];
      target[1] = y_ - settings_.offset[1];
      return move(State::arrive, target, settings_.travel_speed, true);
    case State::arrive:
      if (observation.stopped || observation.triggered) return fail(ProbeFault::triggered_early);
      target[z] = settings_.end_of_descent();
      return move(State::descend, target, settings_.fast_speed, true);
    case State::descend:
      if (!observation.stopped) return fail(ProbeFault::not_triggered);
      target[z] += settings_.back_off;
      return move(State::back_off, target, settings_.fast_speed, false);
    case State::back_off:
      if (observation.triggered) return fail(ProbeFault::does_not_open);
      target[z] =
          std::max(target[z] - settings_.back_off * 2, units::Position(settings_.end_of_descent()));
      return move(State::descend_slowly, target, settings_.slow_speed, true);
    case State::descend_slowly:
      if (!observation.stopped) return fail(ProbeFault::not_triggered);
      result_ = target[z].nearest() + settings_.offset[z];
      target[z] = std::max(target[z], units::Position(settings_.clearance));
      return move(State::raise, target, settings_.fast_speed, false);
    case State::raise:
      state_ = State::idle;
      return std::nullopt;
  }
  return std::nullopt;
}

std::optional<ProbingMove> Probing::move(State next, const units::PerAxis<units::Position>& target,
                                         units::MicrometersPerSecond speed, bool stops) {
  state_ = next;
  return ProbingMove{.target = target, .speed = speed, .stops = stops};
}

std::optional<ProbingMove> Probing::fail(ProbeFault fault) {
  state_ = State::idle;
  fault_ = fault;
  return std::nullopt;
}

}  // namespace motion
