// SPDX-License-Identifier: Apache-2.0
// Moves, dwells, homing, and motors.
#include "application/motion_commands.hpp"

namespace application {
namespace {

using units::Axis;
using units::index_of;

// Marlin's EXTRUDE_MAXLENGTH: more filament in one line, forward or back, is taken for a mistake.
constexpr units::Nanometers longest_extrusion{200'000'000};

// "Move beyond the end of X (0.00 to 200.00)"
host_link::TextLine beyond(Axis axis, units::Nanometers travel) {
  host_link::TextLine line;
  line.text("Move beyond the end of ").character(units::axis_letters[index_of(axis)]);
  return line.text(" (0.00 to ").decimal(travel.count(), 6, 2).character(')');
}

}  // namespace

Progress MotionCommands::move(ActiveCommand& command) {
  const units::MicrometersPerSecond before = coordinates_.kept_feedrate();
  coordinates_.take_feedrate(command.command);
  const Progress progress = append(command);
  if (command.refused) coordinates_.keep_feedrate(before);
  return progress;
}

Progress MotionCommands::append(ActiveCommand& command) {
  const Positions wanted = coordinates_.target_of(command.command);
  if (!representable(wanted)) return command.refuse("Number out of range");

  Positions driven = wanted;
  units::Position& extruder = driven[index_of(Axis::e)];
  const units::Position before = coordinates_.logical()[index_of(Axis::e)];
  if (extruder != before) {
    const bool too_long =
        extruder - before > longest_extrusion || before - extruder > longest_extrusion;
    if (heat_.extrusion_is_cold() || too_long) {
      const char* notice =
          too_long ? "echo: too long extrusion prevented" : "echo: cold extrusion prevented";
      if (command.lines_said == 0 && command.say(notice) == Progress::again) return Progress::again;
      command.lines_said = 1;
      extruder = before;
    }
  }

  const Positions machine = coordinates_.machine_target(driven, motion_.position());
  if (!representable(machine)) return command.refuse("Number out of range");
  if (const auto axis = motion::check_bounds(motion_.limits(), motion_.homed(), machine)) {
    return command.refuse(beyond(*axis, motion_.limits().of(*axis).travel).view());
  }
  const auto accepted = motion_.append({.target = machine, .feedrate = coordinates_.feedrate()});
  if (!accepted) return command.refuse(motion::describe(accepted.error()));
  coordinates_.set_logical(wanted);
  coordinates_.set_planned(motion_.position());
  return Progress::done;
}

Progress MotionCommands::dwell(ActiveCommand& command) {
  if (command.phase == ActiveCommand::Phase::begin) {
    // One more, since the present millisecond has partly passed.
    dwell_end_ = command.now.milliseconds + command.asked_time() + units::Milliseconds(1);
    command.phase = ActiveCommand::Phase::working;
  }
  return command.now.milliseconds >= dwell_end_ ? Progress::done : Progress::again;
}

Progress MotionCommands::home(ActiveCommand& command) {
  if (command.phase == ActiveCommand::Phase::begin) {
    homing_axes_ = command.named_axes();
    homing_axes_.remove(Axis::e);
    if (homing_axes_.empty()) homing_axes_ = units::AxisSet::all();
    motion_.start_homing(homing_axes_);
    command.phase = ActiveCommand::Phase::working;
    return Progress::again;
  }
  if (const auto fault = motion_.homing_fault()) {
    return command.end_everything({Fatal::Reason::homing, *fault, motion_.homing_axis()});
  }
  if (!motion_.at_rest()) return Progress::again;
  // A homed axis loses what G92 has shifted, as in Marlin.
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    const auto axis = static_cast<Axis>(i);
    if (homing_axes_.contains(axis) && motion_.homed().contains(axis)) {
      coordinates_.set_logical(axis, motion_.position()[i]);
    }
  }
  return Progress::done;
}

Progress MotionCommands::switch_on(ActiveCommand& command) { return switch_motors(command, true); }

// With S: only the time after which they are switched off by themselves.
Progress MotionCommands::switch_off(ActiveCommand& command) {
  const auto timeout = command.seconds();
  if (!timeout) return switch_motors(command, false);
  motor_timeout_ = *timeout;
  return Progress::done;
}

Progress MotionCommands::switch_motors(const ActiveCommand& command, bool enabled) {
  units::AxisSet axes = command.named_axes();
  if (axes.empty()) axes = units::AxisSet::all();
  motion_.enable_motors(axes, enabled);
  return Progress::done;
}

Progress MotionCommands::quick_stop(ActiveCommand&) {
  motion_.quick_stop();
  return Progress::done;
}

}  // namespace application
