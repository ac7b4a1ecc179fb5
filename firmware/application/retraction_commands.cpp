// SPDX-License-Identifier: Apache-2.0
// The two moves of each command, the second as soon as the planner has room.
#include "application/retraction_commands.hpp"

#include "application/setting_reports.hpp"

namespace application {

using units::Axis;
using units::index_of;

namespace {

// Marlin's MIN_AUTORETRACT and MAX_AUTORETRACT.
constexpr units::Nanometers least_replaced{100'000}, most_replaced{10'000'000};

}  // namespace

Progress RetractionCommands::begin(ActiveCommand& command, bool extrudes) {
  if (extrudes && heat_.extrusion_is_cold()) {
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

// After a stop Z need not have got there.
void RetractionCommands::drop_void_lift() {
  if (!coordinates_.z_is_set()) {
    const units::Position here = coordinates_.logical()[index_of(Axis::z)];
    coordinates_.set_logical(Axis::z, here + units::Position(lift_.height));
  }
  lift_ = {};
}

Progress RetractionCommands::retract(ActiveCommand& command) {
  State& state = this->state();
  const motion::Retraction& retraction = motion_.limits().retraction;
  if (command.phase == ActiveCommand::Phase::begin) {
    if (state.retracted) return Progress::done;
    // Another tool's lift is enough.
    const bool lifted = units::most_tools > 1 && lift_.height != units::Nanometers() && !jumped();
    if (!lifted) {
      Positions raised = motion_.position();
      raised[index_of(Axis::z)] += units::Position(retraction.lift);
      if (const auto refused = moves_.refuse_beyond_limits(command, raised)) return *refused;
    }
    const Progress progress = begin(command);
    if (command.refused) return progress;
    if (units::most_tools > 1 && lift_.height != units::Nanometers() && jumped()) drop_void_lift();
    const Progress drawn = append(command, Axis::e, -retraction.length, retraction.speed);
    if (command.refused) return drawn;
    state.retracted = true;
    state.length = retraction.length;
    if (lifted) return Progress::done;
    lift_ = {.jumps = motion_.position_jumps()};
    return retraction.lift == units::Nanometers() ? Progress::done : Progress::again;
  }
  if (motion_.stopping() || jumped()) return Progress::done;
  if (!motion_.has_room()) return Progress::again;
  const Progress progress = lift(command, retraction.lift);
  if (!command.refused) lift_.height = retraction.lift;
  coordinates_.watch_z();
  return progress;
}

Progress RetractionCommands::recover(ActiveCommand& command) {
  State& state = this->state();
  const bool only_lowers =
      units::most_tools > 1 && !state.retracted && lift_.height != units::Nanometers();
  if (!state.retracted && !only_lowers) return Progress::done;
  if (command.phase == ActiveCommand::Phase::begin) {
    const bool void_lift = jumped();
    const Progress progress = begin(command, !only_lowers);
    if (command.refused) return progress;
    if (void_lift) {
      drop_void_lift();
    } else if (lift_.height != units::Nanometers()) {
      const Progress lowered = lift(command, -lift_.height);
      if (command.refused) return lowered;
    }
    lift_ = {.jumps = motion_.position_jumps()};
    return only_lowers ? Progress::done : Progress::again;
  }
  if (motion_.stopping() || jumped()) return Progress::done;
  if (!motion_.has_room()) return Progress::again;
  const motion::Retraction& retraction = motion_.limits().retraction;
  state.retracted = false;
  return append(command, Axis::e, state.length + retraction.extra, retraction.recovery_speed);
}

// Where filament is drawn back already, a line backward is what it says; likewise forward.
Progress RetractionCommands::move(ActiveCommand& command) {
  if (!automatic_retraction_in_image) return moves_.move(command);
  const bool begins = command.phase == ActiveCommand::Phase::begin;
  Positions target;
  if (begins) {
    const bool extrudes_alone =
        command.command.has('E') && !command.command.has_any(gcode::Command::set_of("XYZ"));
    if (!extrudes_alone || !motion_.limits().retraction.automatic) return moves_.move(command);
    coordinates_.put_target_of(command.command, target);
    constexpr std::size_t e = index_of(Axis::e);
    const units::Nanometers way = target[e].whole() - coordinates_.logical()[e].whole();
    recovers_ = way > units::Nanometers();
    const units::Nanometers length = recovers_ ? way : -way;
    if (recovers_ != state().retracted || length < least_replaced || length > most_replaced) {
      return moves_.move(command);
    }
  }
  const Progress progress = recovers_ ? recover(command) : retract(command);
  if (begins && !command.refused) {
    coordinates_.take_feedrate(command.command);
    coordinates_.set_logical(Axis::e, target[index_of(Axis::e)]);
  }
  return progress;
}

}  // namespace application
