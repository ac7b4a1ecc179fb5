// SPDX-License-Identifier: Apache-2.0
// The settings of probe and mesh, and whether lines follow the mesh.
#include "application/levelling_commands.hpp"

#include <algorithm>

#include "application/levelling_reports.hpp"
#include "units/loop_bound.hpp"

namespace application {

using namespace std::string_view_literals;
using units::Nanometers;

// All of them need the axes at rest.
Progress LevellingCommands::execute_fitted(ActiveCommand& command) {
  using gcode::Command;
  if (command.phase == ActiveCommand::Phase::begin && !motion_.at_rest()) {
    motion_.flush();
    return Progress::again;
  }
  const auto unknown = [&](std::uint32_t known) { return command.command.has_besides(known); };
  switch (command.command.code) {
    case 29:
      if (unknown(Command::set_of("LRFBXYSV"))) return command.refuse("G29 takes L R F B X Y S V");
      return probe_bed(command);
    case 30:
      if (unknown(Command::set_of("XYE"))) return command.refuse("Unknown parameter");
      return probe_place(command);
    case 420:
      if (unknown(Command::set_of("SZVT"))) return command.refuse("M420 takes S Z V T");
      return set_mesh(command);
    case 421:
      return set_point(command);
    default:
      return set_offset(command);
  }
}

Progress LevellingCommands::set_mesh(ActiveCommand& command) {
  const gcode::Command& line = command.command;
  if (command.phase == ActiveCommand::Phase::begin) {
    const auto fade = coordinates_.rounded_length(line, 'Z');
    if (fade && (*fade < Nanometers() || *fade > motion::BedMesh::most_fade_height)) {
      return command.refuse("Z not within 0 to 1000");
    }
    const bool before = motion_.levelled();
    const Nanometers fade_before = motion_.levelling().mesh.fade_height();
    const auto mode = line.integer('S');
    const bool follow = line.has('S') ? !mode || *mode != 0 : before;
    const auto set_fade = [&](Nanometers height) {
      return [height](motion::Levelling& levelling) { levelling.mesh.set_fade_height(height); };
    };
    const bool changes = follow != before || fade.value_or(fade_before) != fade_before;
    if (changes && !motion_.change_levelling(follow, set_fade(fade.value_or(fade_before)))) {
      motion_.change_levelling(before, set_fade(fade_before));
      return refuse_to_follow(command);
    }
    command.phase = ActiveCommand::Phase::working;
  }
  const bool shows = line.has('V') && motion_.levelling().mesh.complete();
  if (shows && say_mesh(command) == Progress::again) return Progress::again;
  return report_mesh_use(command);
}

// With lines of the mesh before it or not, `lines_said` goes on.
Progress LevellingCommands::report_mesh_use(ActiveCommand& command) {
  const motion::Levelling& levelling = motion_.levelling();
  const std::size_t first =
      command.command.has('V') && levelling.mesh.complete() ? mesh_titles + points(1) : 0;
  if (command.lines_said == first) {
    const auto line = levelling.active ? "echo:Bed Leveling ON"sv : "echo:Bed Leveling OFF"sv;
    if (command.say(line) == Progress::again) return Progress::again;
    ++command.lines_said;
  }
  host_link::TextLine line;
  line.text("echo:Fade Height ");
  const Nanometers fade = levelling.mesh.fade_height();
  if (fade == Nanometers()) return command.say(line.text("OFF"));
  return command.say(line.decimal(fade.count(), 6, 2));
}

Progress LevellingCommands::refuse_to_follow(ActiveCommand& command) {
  command.refused = true;
  return command.say(
      motion_.levelling().mesh.complete()
          ? "Error:Failed to enable Bed Leveling: M420 Z below twice the highest of the mesh"sv
          : "Error:Failed to enable Bed Leveling: no mesh, G29 first"sv);
}

// A line in each pass.
Progress LevellingCommands::say_mesh(ActiveCommand& command) {
  std::size_t& said = command.lines_said;
  if (said >= mesh_titles + points(1)) return Progress::done;
  if (command.say(mesh_line(said, motion_.levelling().mesh)) == Progress::done) ++said;
  return Progress::again;
}

Progress LevellingCommands::set_point(ActiveCommand& command) {
  const gcode::Command& line = command.command;
  const auto height = coordinates_.rounded_length(line, 'Z');
  const auto added = coordinates_.rounded_length(line, 'Q');
  if (height.has_value() == added.has_value() || line.has_besides(gcode::Command::set_of("IJZQ"))) {
    return command.refuse("M421 incorrect parameter usage");
  }
  std::array<std::size_t, 2> first{}, end{points(0), points(1)};
  for (std::size_t i = 0; i < first.size(); ++i) {
    const auto index = line.integer("IJ"[i]);
    if (!index || *index == -1) continue;
    if (*index < 0 || *index >= static_cast<std::int64_t>(end[i])) {
      return command.refuse("Mesh point cannot be resolved");
    }
    first[i] = static_cast<std::size_t>(*index);
    end[i] = first[i] + 1;
  }
  const bool follow = motion_.levelled();
  // First whether it can be, then it is done.
  for (const bool does : {false, true}) {
    std::string_view reason;
    const auto change = [&](motion::Levelling& levelling) {
      units::LoopBound<motion::BedMesh::most_points> rows;
      for (std::size_t row = first[1]; row < end[1]; ++row) {
        rows.next();
        units::LoopBound<motion::BedMesh::most_points, 1> columns;
        for (std::size_t column = first[0]; column < end[0]; ++column) {
          columns.next();
          const auto old = height ? height : levelling.mesh.height(column, row);
          if (!old) {
            reason = "Q needs a mesh, G29 first";
            continue;
          }
          const Nanometers wanted = height ? *height : *old + *added;
          const Nanometers fade = levelling.mesh.fade_height(), twice = wanted * 2;
          if (!motion::BedMesh::may_be(wanted)) {
            reason = "Height not within -10 to 10";
          } else if (follow && fade != Nanometers() && (twice > fade || -twice > fade)) {
            reason = "Height beyond half of the fade height, M420 Z";
          }
          if (does) levelling.mesh.set_height(column, row, wanted);
        }
      }
    };
    const bool follows = motion_.change_levelling(follow, change);
    if (!reason.empty()) return command.refuse(reason);
    if (!follows) return refuse_to_follow(command);
  }
  return Progress::done;
}

Progress LevellingCommands::set_offset(ActiveCommand& command) {
  const gcode::Command& line = command.command;
  if (line.has_besides(gcode::Command::set_of("XYZ"))) return command.refuse("Unknown parameter");
  if (!line.has_any(gcode::Command::set_of("XYZ"))) {
    return command.say(levelling_report(1, motion_.levelling(), coordinates_.inches()));
  }
  auto offset = motion_.levelling().probe.offset;
  units::LoopBound<std::tuple_size_v<decltype(offset)>> axes;
  for (std::size_t i = 0; i < offset.size(); ++i) {
    axes.next();
    const auto asked = coordinates_.rounded_length(line, units::axis_letters[i]);
    if (!asked) continue;
    const bool vertical = i == units::index_of(units::Axis::z);
    const Nanometers most(vertical ? 20'000'000 : 100'000'000);
    if (*asked > most || -*asked > most) {
      return command.refuse(vertical ? "Z not within -20 to 20"sv
                                     : "X or Y not within -100 to 100"sv);
    }
    offset[i] = *asked;
  }
  motion::ProbeSettings changed = motion_.levelling().probe;
  changed.offset = offset;
  if (changed.end_of_descent() >= changed.clearance) {
    return command.refuse("Z would end the descent above the probe's clearance");
  }
  motion_.change_levelling(motion_.levelled(),
                           [&](motion::Levelling& levelling) { levelling.probe.offset = offset; });
  return Progress::done;
}

}  // namespace application
