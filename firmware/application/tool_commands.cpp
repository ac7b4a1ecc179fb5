// SPDX-License-Identifier: Apache-2.0
// The change of tools step by step.
#include "application/tool_commands.hpp"

#include <algorithm>

#include "units/loop_bound.hpp"

namespace application {

using units::Axis;
using units::index_of;
using units::Nanometers;

namespace {

constexpr std::size_t x = index_of(Axis::x), y = index_of(Axis::y), z = index_of(Axis::z),
                      e = index_of(Axis::e);

}  // namespace

// In Marlin's words, by which OctoPrint knows it.
Progress ToolCommands::select(ActiveCommand& command) {
  const std::size_t tool = command.command.code;
  if (tool >= count()) {
    host_link::TextLine line;
    return command.refuse(
        line.text("echo:T").integer(command.command.code).text(" Invalid extruder"));
  }
  if constexpr (units::most_tools > 1) {
    Change& change = this->change();
    if (command.phase == ActiveCommand::Phase::begin) {
      const bool changes = tool != coordinates().tool();
      if (!changes && change.drawn[tool] == Nanometers()) return Progress::done;
      motion().flush();
      if (!motion().at_rest()) return Progress::again;
      plan(tool);
      const bool asked_to_stay = !changes || command.command.integer('S').value_or(0) != 0;
      if (change.moves && !asked_to_stay && !way_is_free()) {
        if (command.say("echo:Out of reach of the new nozzle: the head stays") == Progress::again) {
          return Progress::again;
        }
        change.moves = false;
      }
      change.moves = change.moves && !asked_to_stay;
      begin(command);
    }
    if (change.step != Step::done) {
      // A stop voids what is left of it.
      if (motion().stopping()) return Progress::again;
      if (motion().position_jumps() == change.jumps) {
        if (!motion().at_rest()) return Progress::again;
        // One in each pass: they append lines.
        const Step step = change.step;
        change.step = static_cast<Step>(static_cast<std::uint8_t>(step) + 1);
        if (carry_out(step, tool)) motion().flush();
        return Progress::again;
      }
      note_stop();
    }
    if (!motion().at_rest()) return Progress::again;
    return report_end(command, tool);
  }
  return Progress::done;
}

// The filament is where the stop has left it, and the host's E still does not show it.
void ToolCommands::note_stop() {
  Change& change = this->change();
  if (change.pushes) {
    const Positions& here = motion().position();
    change.drawn[coordinates().tool()] =
        change.drawn_before + (change.extruder - here[e]).nearest();
  }
  coordinates().set_logical(Axis::e, change.logical_extruder);
  change.step = Step::done;
}

// What is not as it was asked for, and what a nozzle lacks that is in use now.
Progress ToolCommands::report_end(ActiveCommand& command, std::size_t tool) {
  const std::size_t in_use = coordinates().tool();
  if (command.lines_said == 0 && (in_use != tool || change().fault)) {
    const Progress said = command.refuse(change().fault ? motion::describe(*change().fault)
                                                        : "The change was stopped, the tool stays");
    if (said == Progress::again) return said;
    command.lines_said = 1;
  }
  const Nanometers drawn = change().drawn[in_use];
  if (drawn == Nanometers()) return Progress::done;
  host_link::TextLine line;
  line.text("echo:Filament is retracted by ").decimal(drawn.count(), 6, 2);
  line.text(" mm, once hot T").integer(static_cast<std::int64_t>(in_use));
  line.text(" pushes it forward");
  return command.say(line);
}

// Up, across and down.
bool ToolCommands::way_is_free() {
  const Change& change = this->change();
  const Positions& here = motion().position();
  Positions above = here, across = change.target;
  above[z] = across[z] = change.height;
  const motion::kinematics::Chosen& kinematics = motion().kinematics();
  return moves().may_go_to(change.target) && kinematics.reaches(above) &&
         kinematics.reaches(across) && kinematics.straight_within(here, above) &&
         kinematics.straight_within(above, across) &&
         kinematics.straight_within(across, change.target);
}

// Where the new nozzle must go. Not homed, nothing is known of the way.
void ToolCommands::plan(std::size_t tool) {
  Change& change = this->change();
  const Positions& here = motion().position();
  change.moves = true;
  change.target = here;
  units::LoopBound<e> axes;
  for (std::size_t i = 0; i < e; ++i) {
    axes.next();
    const Nanometers way = coordinates().tool_offset(i) - coordinates().tools().offset(tool)[i];
    change.target[i] += units::Position(way);
    change.moves = change.moves && motion().homed().contains(static_cast<Axis>(i));
  }
  // No nozzle comes nearer to the part than the lift.
  change.height =
      std::max(here[z], change.target[z]) + units::Position(coordinates().tools().change().lift);
  const units::Position top(motion().limits().of(Axis::z).travel);
  if (change.height > top) change.height = std::max({top, here[z], change.target[z]});
}

void ToolCommands::begin(ActiveCommand& command) {
  Change& change = this->change();
  command.phase = ActiveCommand::Phase::working;
  change.step = Step::retract;
  change.jumps = motion().position_jumps();
  change.resumes = change.pushes = false;
  change.fault.reset();
  change.logical_extruder = coordinates().logical()[e];
  const motion::Limits& limits = motion().limits();
  change.feedrate = std::min(limits.of(Axis::x).max_speed, limits.of(Axis::y).max_speed);
  const units::MicrometersPerSecond kept = coordinates().kept_feedrate();
  coordinates().take_feedrate(command.command);
  if (command.command.has_number('F')) change.feedrate = coordinates().kept_feedrate();
  coordinates().keep_feedrate(kept);
}

bool ToolCommands::carry_out(Step step, std::size_t tool) {
  Change& change = this->change();
  const ToolChange& settings = coordinates().tools().change();
  const bool stays = step == Step::select || step == Step::unretract || step == Step::resume;
  if (!change.moves && !stays) return false;
  Positions place = motion().position();
  change.pushes = false;
  switch (step) {
    case Step::retract:
      return push(coordinates().tool(), -settings.swap, settings.retract_speed);
    case Step::lift:
      place[z] = change.height;
      return go_to(place, motion().limits().of(Axis::z).max_speed);
    case Step::select:
      motion().select_extruder(tool);
      heat().select_tool(tool);
      coordinates().select_tool(tool);
      coordinates().set_planned(motion().position());
      return false;
    // What the last change has drawn back; of a tool that has not been used yet nothing.
    case Step::unretract:
      change.resumes = push(tool, change.drawn[tool], settings.unretract_speed);
      return change.resumes;
    case Step::prime:
      return extrude(settings.prime, settings.prime_speed);
    case Step::travel:
      place[x] = change.target[x];
      place[y] = change.target[y];
      return go_to(place, change.feedrate);
    case Step::lower:
      place[z] = change.target[z];
      return go_to(place, motion().limits().of(Axis::z).max_speed);
    case Step::resume:
      return change.resumes && extrude(settings.resume, settings.unretract_speed);
    case Step::done:
      return false;
  }
  return false;
}

// The tool's filament back or forward, where it is counted.
bool ToolCommands::push(std::size_t tool, Nanometers length, units::MicrometersPerSecond speed) {
  Change& change = this->change();
  change.extruder = motion().position()[e];
  if (!extrude(length, speed)) return false;
  change.pushes = true;
  change.drawn_before = change.drawn[tool];
  change.drawn[tool] -= length;
  return true;
}

// The host's E does not show it. Not with a cold hotend.
bool ToolCommands::extrude(Nanometers length, units::MicrometersPerSecond speed) {
  if (length == Nanometers() || heat().extrusion_is_cold()) return false;
  Positions target = motion().position();
  target[e] += units::Position(length);
  if (!motion().append({.target = target, .feedrate = speed})) return false;
  coordinates().set_planned(motion().position());
  return true;
}

// The host's coordinates change by as much as the machine's.
bool ToolCommands::go_to(const Positions& machine, units::MicrometersPerSecond feedrate) {
  const Positions before = motion().position();
  if (machine == before) return false;
  if (const auto accepted = motion().append({.target = machine, .feedrate = feedrate}); !accepted) {
    change().fault = accepted.error();
    change().step = Step::done;
    return false;
  }
  for (std::size_t i = 0; i < e; ++i) {
    coordinates().set_logical(static_cast<Axis>(i),
                              coordinates().logical()[i] + (machine[i] - before[i]));
  }
  coordinates().set_planned(motion().position());
  return true;
}

}  // namespace application
