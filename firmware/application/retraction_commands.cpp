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
  const units::Position above = motion_.position()[z] - coordinates_.logical()[z];
  if (units::most_tools == 1) return above;
  return above + units::Position(coordinates_.tool_offset(z));
}

Progress RetractionCommands::retract(ActiveCommand& command) {
  State& state = this->state();
  const motion::Retraction& retraction = motion_.limits().retraction;
  if (command.phase == ActiveCommand::Phase::begin) {
    if (state.retracted) return Progress::done;
    const Progress progress = begin(command, retraction.lift);
    if (command.refused) return progress;
    const Progress drawn = append(command, Axis::e, -retraction.length, retraction.speed);
    if (command.refused) return drawn;
    state.retracted = true;
    state.length = retraction.length;
    state.lift = {};
    state.jumps = motion_.position_jumps();
  }
  const bool stopped = motion_.stopping() || motion_.position_jumps() != state.jumps;
  if (stopped || retraction.lift == units::Nanometers()) return Progress::done;
  if (!motion_.has_room()) return Progress::again;
  const Progress progress = lift(command, retraction.lift);
  if (!command.refused) state.lift = retraction.lift;
  state.above_host = above_host();
  return progress;
}

Progress RetractionCommands::recover(ActiveCommand& command) {
  State& state = this->state();
  if (!state.retracted) return Progress::done;
  const bool jumped = motion_.position_jumps() != state.jumps;
  if (command.phase == ActiveCommand::Phase::begin) {
    const Progress progress = begin(command, jumped ? units::Nanometers() : -state.lift);
    if (command.refused) return progress;
    if (jumped && above_host() == state.above_host) {
      const units::Position here = coordinates_.logical()[index_of(Axis::z)];
      coordinates_.set_logical(Axis::z, here + units::Position(state.lift));
    } else if (!jumped && state.lift != units::Nanometers()) {
      const Progress lowered = lift(command, -state.lift);
      if (command.refused) return lowered;
    }
    state.lift = {};
    state.jumps = motion_.position_jumps();
    return Progress::again;
  }
  if (motion_.stopping() || jumped) return Progress::done;
  if (!motion_.has_room()) return Progress::again;
  const motion::Retraction& retraction = motion_.limits().retraction;
  state.retracted = false;
  return append(command, Axis::e, state.length + retraction.extra, retraction.recovery_speed);
}

}  // namespace application
