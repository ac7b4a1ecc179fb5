// SPDX-License-Identifier: Apache-2.0
// The change of tools step by step, and its settings.
#include "application/tool_commands.hpp"

#include <algorithm>

#include "application/setting_reports.hpp"
#include "units/loop_bound.hpp"

namespace application {

using units::Axis;
using units::index_of;
using units::Nanometers;

namespace {

constexpr std::size_t x = index_of(Axis::x), y = index_of(Axis::y), z = index_of(Axis::z),
                      e = index_of(Axis::e);

// Marlin's EXTRUDE_MAXLENGTH, its most of B, and its range of speeds in mm/min.
constexpr Nanometers longest_swap{200'000'000};
constexpr Nanometers longest_resume{10'000'000};
constexpr Nanometers farthest_offset{1'000'000'000};
constexpr Nanometers least_per_minute{10'000'000}, most_per_minute{5'400'000'000};

// The least of Marlin's speeds is 167 um/s.
void take_speed(const std::optional<Nanometers>& per_minute, units::MicrometersPerSecond& speed) {
  if (!per_minute) return;
  const std::int64_t within = std::clamp(*per_minute, least_per_minute, most_per_minute).count();
  speed = units::MicrometersPerSecond(static_cast<std::int32_t>(
      (within + motion::nanometers_per_minute / 2) / motion::nanometers_per_minute));
}

void take_length(const std::optional<Nanometers>& asked, Nanometers least, Nanometers most,
                 Nanometers& length) {
  if (asked) length = std::clamp(*asked, least, most);
}

Progress refuse_unfitted(ActiveCommand& command) {
  host_link::TextLine line;
  line.text("echo:M").integer(command.command.code).text(" not fitted");
  return command.say(line);
}

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
      if (tool == coordinates().tool()) return Progress::done;
      motion().flush();
      if (!motion().at_rest()) return Progress::again;
      plan(tool);
      const bool asked_to_stay = command.command.integer('S').value_or(0) != 0;
      if (change.moves && !asked_to_stay && !moves().may_go_to(change.target)) {
        if (command.say("echo:The new nozzle does not reach this place, and stays") ==
            Progress::again) {
          return Progress::again;
        }
        change.moves = false;
      }
      change.moves = change.moves && !asked_to_stay;
      begin(command);
    }
    units::LoopBound<static_cast<std::size_t>(Step::done) + 1> steps;
    while (change.step != Step::done) {
      steps.next();
      // A stop voids what is left of it.
      if (motion().stopping() || motion().position_jumps() != change.jumps) break;
      if (!motion().at_rest()) return Progress::again;
      const Step step = change.step;
      change.step = static_cast<Step>(static_cast<std::uint8_t>(step) + 1);
      if (carry_out(step, tool)) motion().flush();
    }
    if (!motion().at_rest() && !motion().stopping()) return Progress::again;
  }
  return Progress::done;
}

// Where the new nozzle must go. Not homed, nothing is known of the way.
void ToolCommands::plan(std::size_t tool) {
  Change& change = this->change();
  const Positions& here = motion().position();
  change.moves = true;
  change.target = here;
  for (std::size_t i = 0; i < e; ++i) {
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
  change.resumes = false;
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
  if (!change.moves && step != Step::select) return false;
  Positions place = motion().position();
  switch (step) {
    case Step::retract:
      if (settings.swap == Nanometers() || !extrude(-settings.swap, settings.retract_speed)) {
        return false;
      }
      change.drawn[coordinates().tool()] += settings.swap;
      return true;
    case Step::lift:
      place[z] = change.height;
      return go_to(place, motion().limits().of(Axis::z).max_speed);
    case Step::select:
      motion().select_extruder(tool);
      heat().select_tool(tool);
      coordinates().select_tool(tool);
      coordinates().set_planned(motion().position());
      return false;
    case Step::unretract:
      return unretract(tool);
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

// What the last change has drawn back; of a tool that has not been used yet nothing.
bool ToolCommands::unretract(std::size_t tool) {
  Change& change = this->change();
  if (!extrude(change.drawn[tool], coordinates().tools().change().unretract_speed)) return false;
  change.drawn[tool] = {};
  change.resumes = true;
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
  if (machine == before || !motion().append({.target = machine, .feedrate = feedrate})) {
    return false;
  }
  for (std::size_t i = 0; i < e; ++i) {
    coordinates().set_logical(static_cast<Axis>(i),
                              coordinates().logical()[i] + (machine[i] - before[i]));
  }
  coordinates().set_planned(motion().position());
  return true;
}

Progress ToolCommands::prime(ActiveCommand& command) {
  if (heat().extrusion_is_cold()) return command.refuse("Cold extrusion prevented");
  if (!motion().has_room() || motion().stopping()) return Progress::again;
  const ToolChange& settings = coordinates().tools().change();
  extrude(settings.prime, settings.prime_speed);
  return Progress::done;
}

Progress ToolCommands::set_change(ActiveCommand& command) {
  if (units::most_tools == 1 || count() == 1) return refuse_unfitted(command);
  if constexpr (units::most_tools > 1) {
    if (command.command.has('Q')) return prime(command);
    const auto asked = [&](char letter) {
      return coordinates().rounded_length(command.command, letter);
    };
    ToolChange& settings = coordinates().tools().change();
    take_length(asked('S'), {}, longest_swap, settings.swap);
    take_length(asked('B'), -longest_resume, longest_resume, settings.resume);
    take_length(asked('E'), {}, longest_swap, settings.prime);
    take_length(asked('Z'), {}, motion().limits().of(Axis::z).travel, settings.lift);
    take_speed(asked('P'), settings.prime_speed);
    take_speed(asked('R'), settings.retract_speed);
    take_speed(asked('U'), settings.unretract_speed);
  }
  return command.say(tool_change_report(coordinates().tools().change(), coordinates().inches()));
}

Progress ToolCommands::set_offset(ActiveCommand& command) {
  if (units::most_tools == 1 || count() == 1) return refuse_unfitted(command);
  if constexpr (units::most_tools > 1) {
    const auto tool = command.asked_tool(coordinates().tools());
    if (!tool) return command.refuse_tool();
    std::array<std::optional<Nanometers>, e> offsets;
    for (std::size_t i = 0; i < e; ++i) {
      offsets[i] = coordinates().rounded_length(command.command, units::axis_letters[i]);
      if (offsets[i] && (*offsets[i] > farthest_offset || *offsets[i] < -farthest_offset)) {
        return command.refuse("Number out of range");
      }
    }
    for (std::size_t i = 0; i < e; ++i) {
      if (offsets[i]) coordinates().set_tool_offset(*tool, i, *offsets[i]);
    }
  }
  return Progress::done;
}

Progress ToolCommands::report_offset(ActiveCommand& command) {
  if (units::most_tools == 1 || count() == 1) return refuse_unfitted(command);
  return command.say(tool_offset_report(coordinates().tools().offset(1), coordinates().inches()));
}

Progress ToolCommands::set_mode(ActiveCommand& command) {
  if (units::most_tools == 1 || count() == 1) return refuse_unfitted(command);
  if (command.command.integer('S').value_or(0) > 1) {
    return command.refuse("No duplication: one tool extrudes at a time");
  }
  return command.say("echo:One tool extrudes at a time");
}

}  // namespace application
