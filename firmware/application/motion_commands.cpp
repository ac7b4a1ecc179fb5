// SPDX-License-Identifier: Apache-2.0
// Moves, dwells, homing, and motors.
#include "application/motion_commands.hpp"

#include <algorithm>
#include <string_view>

#include "units/event_bound.hpp"

namespace application {

using namespace std::string_view_literals;
namespace {

using units::Axis;
using units::index_of;

// Marlin's EXTRUDE_MAXLENGTH: more filament in one line, forward or back, is taken for a mistake.
constexpr units::Nanometers longest_extrusion{200'000'000};

// "Move beyond the end of X (0.00 to 200.00)", of the nozzle in use.
// Not inlined, or its line would lie on the stack below other refusals.
[[gnu::noinline]] Progress refuse_beyond(ActiveCommand& command, Axis axis,
                                         units::Nanometers travel, units::Nanometers offset) {
  host_link::TextLine line;
  line.text("echo:Move beyond the end of ").character(units::axis_letters[index_of(axis)]);
  if (units::most_tools == 1) {
    line.text(" (0.00 to ");
  } else {
    line.text(" (").decimal(offset.count(), 6, 2).text(" to ");
  }
  line.decimal((travel + offset).count(), 6, 2).character(')');
  return command.refuse_for(line);
}

}  // namespace

Progress MotionCommands::move(ActiveCommand& command) {
  const units::MicrometersPerSecond before = coordinates_.kept_feedrate();
  coordinates_.take_feedrate(command.command);
  const Progress progress = append(command);
  if (command.refused) coordinates_.keep_feedrate(before);
  return progress;
}

// Until the planner has all of its chords, one with each call behind the first.
Progress MotionCommands::arc(ActiveCommand& command, bool clockwise) {
  if (command.phase != ActiveCommand::Phase::begin) return append_chord(command);
  feedrate_before_arc_ = coordinates_.kept_feedrate();
  coordinates_.take_feedrate(command.command);
  const Progress progress = begin_arc(command, clockwise);
  if (command.refused) coordinates_.keep_feedrate(feedrate_before_arc_);
  return progress;
}

Progress MotionCommands::begin_arc(ActiveCommand& command, bool clockwise) {
  Positions logical, machine;
  if (const auto progress = take_target(command, logical, machine)) return *progress;
  motion::ArcRequest request{.plane = coordinates_.plane(),
                             .clockwise = clockwise,
                             .start = motion_.position(),
                             .target = machine};
  if (const auto progress = take_centre(command, request)) return *progress;
  const auto begun = arc_.begin(request);
  if (!begun) return command.refuse(motion::describe(begun.error()));
  for (const Positions& reached : {arc_.lowest(), arc_.highest()}) {
    if (const auto progress = refuse_beyond_limits(command, reached)) return *progress;
  }
  const std::size_t extruder = index_of(Axis::e);
  const bool prints = request.target[extruder] != request.start[extruder];
  const motion::Limits& limits = motion_.limits();
  const auto acceleration = prints ? limits.print_acceleration : limits.travel_acceleration;
  units::happens<units::Event::settled>(prints);
  arc_feedrate_ = std::min(coordinates_.feedrate(), arc_.speed_limit(limits, acceleration));
  arc_jumps_ = motion_.position_jumps();
  arc_fault_.reset();
  // The chords come in passes of their own.
  command.phase = ActiveCommand::Phase::appending;
  return Progress::again;
}

// All chords are as long: where the first is refused, nothing of the line has changed anything.
Progress MotionCommands::append_first_chord(ActiveCommand& command) {
  const auto accepted = motion_.append({.target = arc_.next(), .feedrate = arc_feedrate_});
  if (!accepted) {
    arc_fault_ = accepted.error();
    coordinates_.keep_feedrate(feedrate_before_arc_);
    return command.refuse(motion::describe(*arc_fault_));
  }
  // Set as at the end of the last chord: after a stop on the way, the distance still to go is
  // subtracted from the position that the host sees.
  Positions logical;
  coordinates_.put_target_of(command.command, logical);
  coordinates_.set_logical(logical);
  coordinates_.set_planned(arc_.target());
  return arc_.done() ? Progress::done : Progress::again;
}

// I, J and K lead from the start to the centre, two of them in each plane.
std::optional<Progress> MotionCommands::take_centre(ActiveCommand& command,
                                                    motion::ArcRequest& request) {
  constexpr std::string_view letters = "IJK";
  const auto axes = motion::axes_of(request.plane);
  bool centred = false;
  for (std::size_t i = 0; i < letters.size(); ++i) {
    const auto offset = coordinates_.rounded_length(command.command, letters[i]);
    if (!offset) continue;
    const std::size_t side = i == index_of(axes[0]) ? 0 : 1;
    if (i != index_of(axes[side])) {
      return command.refuse("I, J or K of another plane than the arc's");
    }
    request.centre[side] = *offset;
    centred = true;
  }
  const auto radius = coordinates_.rounded_length(command.command, 'R');
  if (centred == radius.has_value()) {
    return command.refuse(centred ? "Arc with both R and I, J or K"sv
                                  : "Arc with neither R nor I, J or K");
  }
  if (centred) return std::nullopt;
  const auto set = motion::set_centre(request, *radius);
  return set ? std::nullopt : std::optional(command.refuse(motion::describe(set.error())));
}

// A stop voids what is left of the arc.
Progress MotionCommands::append_chord(ActiveCommand& command) {
  if (motion_.stopping() || motion_.position_jumps() != arc_jumps_) return Progress::done;
  if (!motion_.has_room()) return Progress::again;
  if (!arc_.begun()) return append_first_chord(command);
  if (!arc_fault_) {
    const auto accepted = motion_.append({.target = arc_.next(), .feedrate = arc_feedrate_});
    if (accepted) return arc_.done() ? Progress::done : Progress::again;
    // The arc ends here, and the host's position with it.
    arc_fault_ = accepted.error();
    coordinates_.follow(motion_.position());
  }
  return command.refuse(motion::describe(*arc_fault_));
}

Progress MotionCommands::append(ActiveCommand& command) {
  Positions logical;
  motion::LineMove move;
  if (const auto progress = take_target(command, logical, move.target)) return *progress;
  move.feedrate = coordinates_.feedrate();
  const bool with_babystep = takes_babystep(move.target);
  if (with_babystep) {
    move.target[index_of(Axis::z)] += coordinates_.pending_babystep();
    if (const auto progress = refuse_beyond_limits(command, move.target)) return *progress;
  }
  const auto accepted = motion_.append(move);
  if (!accepted) return command.refuse(motion::describe(accepted.error()));
  if (with_babystep) coordinates_.babystep_made();
  coordinates_.set_logical(logical);
  coordinates_.set_planned(move.target);
  return Progress::done;
}

// Not within a move of Z or E alone, whose feedrate it would change.
bool MotionCommands::takes_babystep(const Positions& machine) const {
  return coordinates_.pending_babystep() != units::Position() &&
         (machine[index_of(Axis::x)] != motion_.position()[index_of(Axis::x)] ||
          machine[index_of(Axis::y)] != motion_.position()[index_of(Axis::y)]);
}

std::optional<Progress> MotionCommands::take_target(ActiveCommand& command, Positions& logical,
                                                    Positions& machine) {
  coordinates_.put_target_of(command.command, logical);
  if (!representable(logical)) return command.refuse("Number out of range");

  coordinates_.put_machine_target(logical, motion_.position(), machine);
  units::Position& extruder = machine[index_of(Axis::e)];
  const units::Position& before = motion_.position()[index_of(Axis::e)];
  if (extruder != before) {
    const bool too_long =
        extruder - before > longest_extrusion || before - extruder > longest_extrusion;
    if (heat_.extrusion_is_cold() || too_long) {
      const std::string_view notice =
          too_long ? "echo: too long extrusion prevented"sv : "echo: cold extrusion prevented"sv;
      if (command.lines_said == 0 && command.say(notice) == Progress::again) return Progress::again;
      command.lines_said = 1;
      extruder = before;  // what is not extruded counts as done
    }
  }

  return refuse_beyond_limits(command, machine);
}

std::optional<Progress> MotionCommands::refuse_beyond_limits(ActiveCommand& command,
                                                             const Positions& machine) {
  if (!representable(machine)) return command.refuse("Number out of range");
  if (const auto axis = axis_out_of_bounds(machine)) {
    const units::Nanometers offset = coordinates_.tool_offset(index_of(*axis));
    return refuse_beyond(command, *axis, motion_.limits().of(*axis).travel, offset);
  }
  return std::nullopt;
}

std::optional<Axis> MotionCommands::axis_out_of_bounds(const Positions& machine) const {
  if (!soft_limits_) return std::nullopt;
  const bool lifted = motion_.position_jumps() == lift_->jumps;
  return motion::check_bounds(motion_.limits(), motion_.homed(), machine,
                              lifted ? lift_->height : units::Nanometers());
}

bool MotionCommands::may_go_to(const Positions& machine) const {
  return representable(machine) && motion_.kinematics().reaches(machine) &&
         !axis_out_of_bounds(machine);
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
      coordinates_.axis_homed(axis, motion_.position()[i]);
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

Progress MotionCommands::set_soft_limits(ActiveCommand& command) {
  soft_limits_ = command.integer('S').value_or(0) != 0;
  return Progress::done;
}

// "echo:Soft endstops: ON  Min: X0.00 Y0.00 Z0.00  Max: X200.00 Y200.00 Z110.00"
Progress MotionCommands::report_soft_limits(ActiveCommand& command) {
  host_link::TextLine line;
  line.text("echo:Soft endstops: ").text(soft_limits_ ? "ON"sv : "OFF"sv);
  if (units::most_tools == 1) {
    line.text("  Min: X0.00 Y0.00 Z0.00  Max:");
  } else {
    line.text("  Min:");
    for (std::size_t i = 0; i < index_of(Axis::e); ++i) {
      line.character(' ').character(units::axis_letters[i]);
      line.decimal(coordinates_.tool_offset(i).count(), 6, 2);
    }
    line.text("  Max:");
  }
  for (std::size_t i = 0; i < index_of(Axis::e); ++i) {
    line.character(' ').character(units::axis_letters[i]);
    line.decimal((motion_.limits().axes[i].travel + coordinates_.tool_offset(i)).count(), 6, 2);
  }
  return command.say(line);
}

}  // namespace application
