// SPDX-License-Identifier: Apache-2.0
// Turns the numbers of G0 to G3 and G92 into positions: units, absolute or relative, workspaces,
// factors of E.
#pragma once

#include <cstdint>
#include <optional>

#include "application/tools.hpp"
#include "application/workspaces.hpp"
#include "gcode/command.hpp"
#include "motion/arc.hpp"
#include "units/axes.hpp"
#include "units/position.hpp"
#include "units/quantity.hpp"

namespace application {

using Positions = units::PerAxis<units::Position>;

// Whether the position is within the planner's range.
bool representable(const Positions& positions);

class Coordinates {
 public:
  // G90, G91 for all axes, M82, M83 for E alone: the last one holds, as in Marlin.
  void set_relative(bool relative) { axes_relative_ = extruder_relative_ = relative; }
  void set_extruder_relative(bool relative) { extruder_relative_ = relative; }
  // G20, G21.
  void set_inches(bool inches) { inches_ = inches; }
  bool inches() const { return inches_; }
  // G17 to G19.
  void set_plane(motion::Plane plane) { plane_ = plane; }
  motion::Plane plane() const { return plane_; }
  // M221 of a tool, percent of what lines request; 1 or more.
  void set_flow(std::size_t tool, std::int32_t percent) { feeds_[tool].flow_percent = percent; }
  // M200: E counts mm³ of filament of this diameter, in whole um; 0: mm, as from the start. What it
  // was last can be switched off and on, for all tools.
  static constexpr std::int64_t nanometers_per_micrometer = 1'000;
  static constexpr units::Nanometers least_filament{500'000}, thickest_filament{10'000'000};
  void set_filament(std::size_t tool, units::Nanometers diameter);
  void set_volumetric(bool on) { volumetric_ = on; }
  bool volumetric() const { return volumetric_ && feed().filament.count() != 0; }
  units::Nanometers filament(std::size_t tool) const { return feeds_[tool].filament; }
  // The host's coordinates are those of the nozzle in use.
  const Tools& tools() const { return tools_; }
  Tools& tools() { return tools_; }
  std::size_t tool() const { return tools_.in_use(); }
  // T, and M218 of a tool: the machine stands, so another nozzle is elsewhere.
  void select_tool(std::size_t tool);
  void set_tool_offset(std::size_t tool, std::size_t axis, units::Nanometers offset);
  void restore_tools(const MachineDescription& machine);
  // X, Y or Z of the nozzle in use from that of tool 0.
  units::Nanometers tool_offset(std::size_t axis) const {
    return units::most_tools == 1 ? units::Nanometers() : tools_.offset(tool())[axis];
  }
  // M290: how much higher Z is than the host's coordinate says, since Z was homed, and what of it
  // is still to be made with the next line along X or Y.
  void add_babystep(const units::Position& step) {
    babystep_ += step;
    pending_babystep_ += step;
  }
  void babystep_made() { pending_babystep_ = {}; }
  const units::Position& babystep() const { return babystep_; }
  const units::Position& pending_babystep() const { return pending_babystep_; }
  // M220, percent of the feedrates, and how much of it is to be planned; 1 or more.
  void set_speed(std::int32_t percent, std::int32_t planned_percent) {
    speed_percent_ = percent;
    planned_percent_ = planned_percent;
  }

  std::int32_t flow(std::size_t tool) const { return feeds_[tool].flow_percent; }
  std::int32_t speed() const { return speed_percent_; }
  std::int32_t planned_speed() const { return planned_percent_; }

  // The positions of the axes in the host's coordinates.
  const Positions& logical() const { return logical_; }
  void set_logical(units::Axis axis, const units::Position& position) {
    logical_[units::index_of(axis)] = position;
  }
  void set_logical(const Positions& positions) { logical_ = positions; }
  // G53 to G59.3, G92, G92.1, M206, M428: what moves the host's coordinates, and `change` is what
  // it does.
  const Workspaces& workspaces() const { return workspaces_; }
  template <class Change>
  void change_workspaces(const Change& change) {
    add_origins(true);
    change(workspaces_);
    add_origins(false);
  }
  // G92 of an axis.
  void rename_place(units::Axis axis, const units::Position& position);
  // The axis is homed, and is there in the machine's coordinates.
  void axis_homed(units::Axis axis, const units::Position& machine);
  // Whether homing or G92 has set the host's Z since it was last watched.
  bool z_is_set() const { return z_is_set_; }
  void watch_z() { z_is_set_ = false; }
  // The machine's position at the end of the last move.
  void set_planned(const Positions& machine) { planned_ = machine; }
  // After a stop or homing the machine is elsewhere: the host's position changes by the same.
  void follow(const Positions& machine);

  // A length parameter in the present unit.
  std::optional<units::Position> length(const gcode::Command& command, char letter) const;
  // The same rounded to nanometres, for values that are not positions.
  std::optional<units::Nanometers> rounded_length(const gcode::Command& command, char letter) const;

  // The logical positions that a move requests.
  Positions target_of(const gcode::Command& command) const {
    Positions target;
    put_target_of(command, target);
    return target;
  }
  void put_target_of(const gcode::Command& command, Positions& target) const;
  // The machine positions of a logical target, from where the machine is. Exact, flow included.
  void put_machine_target(const Positions& target, const Positions& machine,
                          Positions& result) const;

  // F in units per minute: kept for this and later moves; not more than 0 is ignored, as in Marlin.
  void take_feedrate(const gcode::Command& command);
  units::MicrometersPerSecond kept_feedrate() const { return feedrate_; }
  void keep_feedrate(units::MicrometersPerSecond feedrate) { feedrate_ = feedrate; }
  // With what is to be planned of the speed factor; 1 um/s at least.
  units::MicrometersPerSecond feedrate() const;

 private:
  // How a tool's filament follows E.
  struct Feed {
    units::Nanometers filament{};
    std::uint64_t length_of_volume{};  // mm for a mm³, in 2^-32
    std::int32_t flow_percent{100};
  };

  void add_origins(bool subtract);
  const Feed& feed() const { return feeds_[tool()]; }

  Positions logical_{};
  Positions planned_{};
  motion::Plane plane_{};
  bool axes_relative_{};
  bool extruder_relative_{};
  bool inches_{};
  bool z_is_set_{};
  Workspaces workspaces_;
  units::Position babystep_{};
  units::Position pending_babystep_{};
  bool volumetric_{};
  std::array<Feed, units::most_tools> feeds_{};
  [[no_unique_address]] Tools tools_;
  std::int32_t speed_percent_{100};
  std::int32_t planned_percent_{100};
  units::MicrometersPerSecond feedrate_{25'000};  // Marlin's default: 1500 mm/min
};

}  // namespace application
