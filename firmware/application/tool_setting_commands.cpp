// SPDX-License-Identifier: Apache-2.0
// What a change of tools does, and where nozzles are: M217 M218 M605.
#include <algorithm>

#include "application/setting_reports.hpp"
#include "application/tool_commands.hpp"

namespace application {

using units::Axis;
using units::index_of;
using units::Nanometers;

namespace {

constexpr std::size_t e = index_of(Axis::e);

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

// Until it has ended: the host's E does not show it, also where a stop leaves only a part of it.
Progress ToolCommands::prime(ActiveCommand& command) {
  Change& change = this->change();
  if (command.phase == ActiveCommand::Phase::begin) {
    if (heat().extrusion_is_cold()) return command.refuse("Cold extrusion prevented");
    motion().flush();
    if (!motion().at_rest()) return Progress::again;
    change.jumps = motion().position_jumps();
    change.logical_extruder = coordinates().logical()[e];
    const ToolChange& settings = coordinates().tools().change();
    extrude(settings.prime, settings.prime_speed);
    motion().flush();
    command.phase = ActiveCommand::Phase::working;
  }
  if (motion().stopping()) return Progress::again;
  if (motion().position_jumps() != change.jumps) {
    coordinates().set_logical(Axis::e, change.logical_extruder);
    return Progress::done;
  }
  return motion().at_rest() ? Progress::done : Progress::again;
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
