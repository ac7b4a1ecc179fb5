// SPDX-License-Identifier: Apache-2.0
// The filament's commands in Marlin's words.
#include "application/filament_commands.hpp"

#include <algorithm>

namespace application {

using units::Axis;
using units::index_of;
using units::Nanometers;
using std::literals::operator""sv;

void FilamentCommands::attach(const MachineDescription& machine, MotionTask& motion, HeatTask& heat,
                              MotionCommands& moves, Coordinates& coordinates,
                              const TimerCommands& timer) {
  machine_ = &machine;
  motion_ = &motion;
  heat_ = &heat;
  moves_ = &moves;
  coordinates_ = &coordinates;
  timer_ = &timer;
  restore();
}

void FilamentCommands::restore() {
  watches_ = true;
  reset();
  if (!has_change()) return;
  load_.fill(machine_->filament_change->load);
  unload_.fill(machine_->filament_change->unload);
}

void FilamentCommands::watch(units::Milliseconds now) {
  if (!timer_->running()) cancelled_ = expected_ = false;
  const bool looks = has_sensor() && watches_ && timer_->running() && !cancelled_ && !at_work_;
  if (!looks) return reset();
  if ((motion_->end_stops() >> machine_->filament_sensor->input & 1u) == 0) {
    without_ = false;
    expected_ = false;
    return;
  }
  if (expected_) return;
  if (!without_) without_since_ = now;
  without_ = true;
  if (now - without_since_ >= time_without) has_run_out_ = true;
}

Progress FilamentCommands::execute(ActiveCommand& command) {
  const std::uint16_t code = command.command.code;
  if (code == 412 ? !has_sensor() : !has_change()) return command.report_not_fitted();
  if (code == 412) return set_sensor(command);
  return code == 603 ? set_lengths(command) : move(command, code == 701);
}

// R, and S too, forget what the sensor has seen.
Progress FilamentCommands::set_sensor(ActiveCommand& command) {
  const gcode::Command& line = command.command;
  if (!line.has_any(gcode::Command::set_of("RS"))) {
    return command.say(watches_ ? "echo:Filament runout ON"sv : "echo:Filament runout OFF"sv);
  }
  reset();
  expected_ = false;
  if (line.has('S')) watches_ = line.integer('S').value_or(1) != 0;
  return Progress::done;
}

Progress FilamentCommands::set_lengths(ActiveCommand& command) {
  const gcode::Command& line = command.command;
  const auto tool = command.asked_tool(coordinates_->tools());
  if (!tool) return command.refuse_tool();
  const auto load = coordinates_->rounded_length(line, 'L');
  const auto unload = coordinates_->rounded_length(line, 'U');
  if (!load && !unload) return command.say(lengths_report(*tool, coordinates_->inches()));
  for (const auto& asked : {load, unload}) {
    if (asked && (*asked < Nanometers() || *asked > FilamentChange::longest)) {
      return command.refuse("L or U not within 0 to 2000 mm");
    }
  }
  load_[*tool] = load.value_or(load_[*tool]);
  unload_[*tool] = unload.value_or(unload_[*tool]);
  return Progress::done;
}

// "echo: M603 L420.00 U450.00", with T where there are two tools.
host_link::TextLine FilamentCommands::lengths_report(std::size_t tool, bool inches) const {
  host_link::TextLine line;
  line.text("echo: M603");
  if (units::most_tools > 1 && coordinates_->tools().count() > 1) {
    line.text(" T").integer(static_cast<std::int64_t>(tool));
  }
  const auto put = [&](char letter, Nanometers length) {
    line.character(' ').character(letter);
    line.decimal(inches ? length.count() * 10 / 254 : length.count(), 6, 2);
  };
  put('L', load_[tool]);
  put('U', unload_[tool]);
  return line;
}

std::optional<host_link::TextLine> FilamentCommands::report(std::size_t index, bool inches) const {
  if (has_sensor()) {
    host_link::TextLine line;
    if (index == 0) return line.text("echo: M412 S").character(watches_ ? '1' : '0');
    --index;
  }
  if (!has_change() || index >= coordinates_->tools().count()) return std::nullopt;
  return lengths_report(index, inches);
}

// Up by Z, the filament, down again. Marlin takes lengths of either sign.
std::optional<Progress> FilamentCommands::plan(ActiveCommand& command, bool loads) {
  const gcode::Command& line = command.command;
  const FilamentChange& change = *machine_->filament_change;
  const auto tool = command.asked_tool(coordinates_->tools());
  if (!tool) return command.refuse_tool();
  if (*tool != coordinates_->tool()) return command.refuse("T is not the tool in use");
  if (heat_->extrusion_is_cold()) return command.refuse("Hotend too cold");
  const auto size = [](Nanometers length) { return length < Nanometers() ? -length : length; };
  const Nanometers length = size(coordinates_->rounded_length(line, loads ? 'L' : 'U')
                                     .value_or(loads ? load_[*tool] : unload_[*tool]));
  if (length > FilamentChange::longest) return command.refuse("L or U not within 0 to 2000 mm");
  const Nanometers lift = size(coordinates_->rounded_length(line, 'Z').value_or(Nanometers()));
  Positions lifted = motion_->position();
  lifted[index_of(Axis::z)] += lift;
  if (const auto refused = moves_->refuse_beyond_limits(command, lifted)) return refused;
  const units::MicrometersPerSecond z_speed = motion_->limits().of(Axis::z).max_speed;
  plan_ = {Move{Axis::z, lift, z_speed},
           Move{Axis::e, loads ? length : -length, loads ? change.load_speed : change.unload_speed},
           Move{Axis::e, loads ? change.purge : Nanometers(), change.purge_speed},
           Move{Axis::z, -lift, z_speed}};
  next_ = 0;
  reason_ = {};
  jumps_ = motion_->position_jumps();
  extruder_ = coordinates_->logical()[index_of(Axis::e)];
  height_shift_ =
      coordinates_->logical()[index_of(Axis::z)] - motion_->position()[index_of(Axis::z)];
  return std::nullopt;
}

// What the host calls E is as before, and its Z differs by what is left of the lift.
void FilamentCommands::note_stop() {
  coordinates_->set_logical(Axis::e, extruder_);
  coordinates_->set_logical(Axis::z, motion_->position()[index_of(Axis::z)] + height_shift_);
}

// The host's coordinates do not show it. A stop voids what is left.
Progress FilamentCommands::move(ActiveCommand& command, bool loads) {
  if (command.phase == ActiveCommand::Phase::begin) return begin(command, loads);
  if (motion_->stopping()) return Progress::again;
  if (motion_->position_jumps() != jumps_) {
    note_stop();
    at_work_ = false;
    return Progress::done;
  }
  if (!motion_->at_rest()) return Progress::again;
  return next_ == plan_.size() ? end(command) : go_on();
}

Progress FilamentCommands::begin(ActiveCommand& command, bool loads) {
  motion_->flush();
  if (!motion_->at_rest()) return Progress::again;
  if (const auto refused = plan(command, loads)) return *refused;
  at_work_ = true;
  expected_ = !loads;
  command.phase = ActiveCommand::Phase::working;
  return Progress::again;
}

// What cannot be moved is left out, so that Z is lowered again.
Progress FilamentCommands::go_on() {
  const Move& next = plan_[next_];
  ++next_;
  if (next.distance == Nanometers()) return Progress::again;
  if (next.axis == Axis::e && heat_->extrusion_is_cold()) reason_ = "Hotend too cold";
  if (next.axis == Axis::e && !reason_.empty()) return Progress::again;
  Positions target = motion_->position();
  target[index_of(next.axis)] += next.distance;
  const auto accepted = motion_->append({.target = target, .feedrate = next.speed});
  if (!accepted) {
    reason_ = motion::describe(accepted.error());
    if (next.axis == Axis::z) next_ = plan_.size();
  }
  coordinates_->set_planned(motion_->position());
  motion_->flush();
  return Progress::again;
}

Progress FilamentCommands::end(ActiveCommand& command) {
  at_work_ = false;
  return reason_.empty() ? Progress::done : command.refuse(reason_);
}

}  // namespace application
