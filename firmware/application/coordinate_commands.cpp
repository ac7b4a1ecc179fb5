// SPDX-License-Identifier: Apache-2.0
// Places that get other coordinates, and E by volume.
#include "application/coordinate_commands.hpp"

#include "units/loop_bound.hpp"

namespace application {

using units::Axis;
using units::index_of;
using units::Position;

Progress CoordinateCommands::set_position(ActiveCommand& command) {
  if (command.command.subcode == 1) {
    coordinates_.change_workspaces([](Workspaces& workspaces) { workspaces.reset_shifts(); });
    return Progress::done;
  }
  Positions positions = coordinates_.logical();
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    const auto value = coordinates_.length(command.command, units::axis_letters[i]);
    if (value) positions[i] = *value;
  }
  if (!representable(positions)) return command.refuse("Number out of range");
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    coordinates_.rename_place(static_cast<Axis>(i), positions[i]);
  }
  return Progress::done;
}

Progress CoordinateCommands::select_system(ActiveCommand& command, std::size_t system) {
  system += command.command.subcode;
  coordinates_.change_workspaces([system](Workspaces& workspaces) { workspaces.select(system); });
  return Progress::done;
}

// Without D only whether it holds: S0 lets E count mm again, S1 mm³ of the diameter before.
Progress CoordinateCommands::set_filament(ActiveCommand& command) {
  const auto tool = command.asked_tool(coordinates_.tools());
  if (!tool) return command.refuse_tool();
  if (const auto asked = coordinates_.rounded_length(command.command, 'D')) {
    constexpr std::int64_t unit = Coordinates::nanometers_per_micrometer;
    const units::Nanometers diameter((asked->count() + unit / 2) / unit * unit);
    if (diameter.count() != 0 &&
        (diameter < Coordinates::least_filament || diameter > Coordinates::thickest_filament)) {
      return command.refuse("D is neither 0 nor 0.5 to 10 mm");
    }
    coordinates_.set_filament(*tool, diameter);
    // D0 of one of two tools switches it off for both, as in Marlin.
    if (units::most_tools > 1 && diameter.count() == 0) return Progress::done;
  }
  if (units::most_tools == 1 || command.command.has_any(gcode::Command::set_of("DS"))) {
    coordinates_.set_volumetric(command.command.integer('S').value_or(1) != 0);
  }
  return Progress::done;
}

// "M200 S1 D1.75"; of two tools "M200 S1 T0 D1.75 T1 D1.75"
Progress CoordinateCommands::report_filament(ActiveCommand& command) {
  host_link::TextLine line;
  line.text("M200 S").integer(coordinates_.volumetric() ? 1 : 0);
  const std::size_t tools = coordinates_.tools().count();
  units::LoopBound<units::most_tools> bound;
  for (std::size_t tool = 0; tool < tools; ++tool) {
    bound.next();
    if (units::most_tools > 1 && tools > 1) {
      line.text(" T").integer(static_cast<std::int64_t>(tool));
    }
    line.text(" D").decimal(coordinates_.filament(tool).count(), 6, 3);
  }
  return command.say(line);
}

Progress CoordinateCommands::set_home_offset(ActiveCommand& command) {
  coordinates_.change_workspaces([&](Workspaces& workspaces) {
    for (std::size_t i = 0; i < Workspaces::axes; ++i) {
      const auto value = coordinates_.rounded_length(command.command, units::axis_letters[i]);
      if (value && Position(*value) <= motion::max_position &&
          Position(-*value) <= motion::max_position) {
        workspaces.set_home_offset(i, *value);
      }
    }
  });
  return Progress::done;
}

// "M206 X0.000 Y0.000 Z-0.200"
Progress CoordinateCommands::report_home_offset(ActiveCommand& command) {
  host_link::TextLine line;
  line.text("M206");
  for (std::size_t i = 0; i < Workspaces::axes; ++i) {
    line.character(' ').character(units::axis_letters[i]);
    line.decimal(coordinates_.workspaces().home_offset()[i].nearest().count(), 6, 3);
  }
  return command.say(line);
}

Progress CoordinateCommands::take_home_offset(ActiveCommand& command) {
  constexpr units::Nanometers farthest{20'000'000};  // Marlin's
  std::array<units::Nanometers, Workspaces::axes> offsets;
  for (std::size_t i = 0; i < Workspaces::axes; ++i) {
    const auto axis = static_cast<Axis>(i);
    if (!motion_.homed().contains(axis)) return command.refuse("Home XYZ first");
    const units::Nanometers travel = motion_.limits().of(axis).travel;
    const units::Nanometers here = motion_.position()[i].nearest() + coordinates_.tool_offset(i);
    const units::Nanometers end = here > travel / 2 ? travel : units::Nanometers();
    if (end - here > farthest || here - end > farthest) {
      return command.refuse("Too far from the reference point");
    }
    offsets[i] = end - here;
  }
  coordinates_.change_workspaces([&offsets](Workspaces& workspaces) {
    for (std::size_t i = 0; i < Workspaces::axes; ++i) workspaces.set_home_offset(i, offsets[i]);
  });
  return Progress::done;
}

}  // namespace application
