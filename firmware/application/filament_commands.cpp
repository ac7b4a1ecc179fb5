// SPDX-License-Identifier: Apache-2.0
// The filament's commands in Marlin's words.
#include "application/filament_commands.hpp"

#include <algorithm>

namespace application {

using units::Axis;
using units::index_of;
using units::Nanometers;

void FilamentCommands::attach(const MachineDescription& machine, MotionTask& motion, HeatTask& heat,
                              MotionCommands& moves, Coordinates& coordinates,
                              const TimerCommands& timer) {
  machine_ = &machine;
  motion_ = &motion;
  heat_ = &heat;
  moves_ = &moves;
  coordinates_ = &coordinates;
  timer_ = &timer;
  watches_ = true;
  reset();
  if (!has_change()) return;
  load_ = machine.filament_change->load;
  unload_ = machine.filament_change->unload;
}

void FilamentCommands::watch(units::Milliseconds now) {
  if (!timer_->running()) cancelled_ = false;
  const bool looks = has_sensor() && watches_ && timer_->running() && !cancelled_;
  if (!looks || (motion_->end_stops() >> machine_->filament_sensor->input & 1u) == 0) {
    without_ = false;
    return;
  }
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
    return command.say(watches_ ? "echo:Filament runout ON" : "echo:Filament runout OFF");
  }
  reset();
  if (line.has('S')) watches_ = line.integer('S').value_or(1) != 0;
  return Progress::done;
}

Progress FilamentCommands::set_lengths(ActiveCommand& command) {
  const gcode::Command& line = command.command;
  if (!command.asked_tool(coordinates_->tools())) return command.refuse_tool();
  const auto load = coordinates_->rounded_length(line, 'L');
  const auto unload = coordinates_->rounded_length(line, 'U');
  if (!load && !unload) {
    const auto put = [&](host_link::TextLine& report, Nanometers length) {
      const std::int64_t count = length.count();
      report.decimal(coordinates_->inches() ? count * 10 / 254 : count, 6, 2);
    };
    host_link::TextLine report;
    put(report.text("echo: M603 L"), load_);
    put(report.text(" U"), unload_);
    return command.say(report);
  }
  for (const auto& asked : {load, unload}) {
    if (asked && (*asked < Nanometers() || *asked > FilamentChange::longest)) {
      return command.refuse("L or U not within 0 to 2000 mm");
    }
  }
  load_ = load.value_or(load_);
  unload_ = unload.value_or(unload_);
  return Progress::done;
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
  const Nanometers length =
      size(coordinates_->rounded_length(line, loads ? 'L' : 'U').value_or(loads ? load_ : unload_));
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
  if (command.phase == ActiveCommand::Phase::begin) {
    motion_->flush();
    if (!motion_->at_rest()) return Progress::again;
    if (const auto refused = plan(command, loads)) return *refused;
    command.phase = ActiveCommand::Phase::working;
  }
  if (motion_->stopping()) return Progress::again;
  if (motion_->position_jumps() != jumps_) {
    note_stop();
    return Progress::done;
  }
  if (!motion_->at_rest()) return Progress::again;
  if (next_ == plan_.size()) return Progress::done;
  const Move& next = plan_[next_];
  ++next_;
  if (next.distance == Nanometers()) return Progress::again;
  Positions target = motion_->position();
  target[index_of(next.axis)] += next.distance;
  const auto accepted = motion_->append({.target = target, .feedrate = next.speed});
  if (!accepted) return command.refuse(motion::describe(accepted.error()));
  coordinates_->set_planned(motion_->position());
  motion_->flush();
  return Progress::again;
}

}  // namespace application
