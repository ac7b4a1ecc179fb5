// SPDX-License-Identifier: Apache-2.0
// The two moves of each command, the second as soon as the planner has room.
#include "application/retraction_commands.hpp"

namespace application {

using units::Axis;
using units::index_of;

// `done` where the moves may follow.
Progress RetractionCommands::begin(ActiveCommand& command, units::Nanometers lift) {
  Positions lifted = motion_.position();
  lifted[index_of(Axis::z)] = lifted[index_of(Axis::z)] + units::Position(lift);
  if (const auto refused = moves_.refuse_beyond_limits(command, lifted)) return *refused;
  if (heat_.extrusion_is_cold()) {
    command.refused = true;
    return command.say("echo: cold extrusion prevented");
  }
  command.phase = ActiveCommand::Phase::appending;
  return Progress::done;
}

Progress RetractionCommands::append(ActiveCommand& command, Axis axis, units::Nanometers distance,
                                    units::MicrometersPerSecond speed) {
  Positions target = motion_.position();
  target[index_of(axis)] = target[index_of(axis)] + units::Position(distance);
  const auto accepted = motion_.append({.target = target, .feedrate = speed});
  if (!accepted) return command.refuse(motion::describe(accepted.error()));
  coordinates_.set_planned(motion_.position());
  return Progress::done;
}

Progress RetractionCommands::lift(ActiveCommand& command, units::Nanometers distance) {
  return append(command, Axis::z, distance, motion_.limits().of(Axis::z).max_speed);
}

units::Position RetractionCommands::above_host() const {
  constexpr std::size_t z = index_of(Axis::z);
  return motion_.position()[z] - coordinates_.logical()[z];
}

Progress RetractionCommands::retract(ActiveCommand& command) {
  const motion::Retraction& retraction = motion_.limits().retraction;
  if (command.phase == ActiveCommand::Phase::begin) {
    if (retracted_) return Progress::done;
    const Progress progress = begin(command, retraction.lift);
    if (command.refused) return progress;
    const Progress drawn = append(command, Axis::e, -retraction.length, retraction.speed);
    if (command.refused) return drawn;
    retracted_ = true;
    length_ = retraction.length;
    lift_ = {};
    jumps_ = motion_.position_jumps();
  }
  const bool stopped = motion_.stopping() || motion_.position_jumps() != jumps_;
  if (stopped || retraction.lift == units::Nanometers()) return Progress::done;
  if (!motion_.has_room()) return Progress::again;
  const Progress progress = lift(command, retraction.lift);
  if (!command.refused) lift_ = retraction.lift;
  above_host_ = above_host();
  return progress;
}

Progress RetractionCommands::recover(ActiveCommand& command) {
  if (!retracted_) return Progress::done;
  const bool jumped = motion_.position_jumps() != jumps_;
  if (command.phase == ActiveCommand::Phase::begin) {
    const Progress progress = begin(command, jumped ? units::Nanometers() : -lift_);
    if (command.refused) return progress;
    if (jumped && above_host() == above_host_) {
      const units::Position here = coordinates_.logical()[index_of(Axis::z)];
      coordinates_.set_logical(Axis::z, here + units::Position(lift_));
    } else if (!jumped && lift_ != units::Nanometers()) {
      const Progress lowered = lift(command, -lift_);
      if (command.refused) return lowered;
    }
    lift_ = {};
    jumps_ = motion_.position_jumps();
    return Progress::again;
  }
  if (motion_.stopping() || jumped) return Progress::done;
  if (!motion_.has_room()) return Progress::again;
  const motion::Retraction& retraction = motion_.limits().retraction;
  retracted_ = false;
  return append(command, Axis::e, length_ + retraction.extra, retraction.recovery_speed);
}

}  // namespace application
