// SPDX-License-Identifier: Apache-2.0
// The commands for the limits of the axes: M92 M201 M203 M204 M205 M501 to M503.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "application/active_command.hpp"
#include "application/coordinates.hpp"
#include "application/motion_task.hpp"
#include "motion/kinematics/delta.hpp"
#include "motion/limits.hpp"

namespace application {

class SettingCommands {
 public:
  SettingCommands(const MachineDescription& machine, MotionTask& motion, Coordinates& coordinates,
                  FilamentCommands* filament)
      : machine_(machine), motion_(motion), coordinates_(coordinates), filament_(filament) {}

  Progress set_steps_per_millimeter(ActiveCommand& command);
  Progress set_max_accelerations(ActiveCommand& command);
  Progress set_max_speeds(ActiveCommand& command);
  Progress set_accelerations(ActiveCommand& command);
  Progress set_advanced(ActiveCommand& command);
  // M207, M208, M209.
  Progress set_retraction(ActiveCommand& command);
  // M425, and its report.
  Progress set_backlash(ActiveCommand& command) {
    return motion_.takes_up_backlash() ? set_fitted_backlash(command) : command.report_not_fitted();
  }
  // M665 and M666 of a delta, and their reports.
  Progress set_geometry(ActiveCommand& command);
  Progress set_end_stop_offsets(ActiveCommand& command);
  Progress report_geometry(ActiveCommand& command);
  // Any of these without values.
  Progress report(ActiveCommand& command);
  Progress list(ActiveCommand& command);
  // M501, which then lists them, and M502: as the machine description has them.
  Progress restore(ActiveCommand& command, bool lists);

 private:
  // A limit that is not of one axis, and the letter of its value.
  struct Setting {
    char letter;
    motion::Accepted (*set)(motion::Limits&, units::Nanometers);
  };
  struct Settings {
    std::array<Setting, 5> accelerations;
    std::array<Setting, 3> advanced;
    std::array<Setting, 3> retraction;
    std::array<Setting, 2> recovery;
    std::array<Setting, 1> automatic;
  };
  template <class Quantity>
  using SetOfAxis = motion::Accepted (*)(motion::Limits&, units::Axis, Quantity);

  // Inlined as in CommandGroups.
  [[gnu::always_inline]] bool handles_filament() const {
    return filament_in_image && filament_ != nullptr;
  }
  // What M503 lists, line by line; nothing behind the last one.
  std::optional<host_link::TextLine> listed(std::size_t index) const;
  Progress set_fitted_backlash(ActiveCommand& command);
  void change_geometry(const motion::kinematics::Delta::Parameters& geometry);
  void restore_geometry();
  host_link::TextLine geometry_report(bool of_m665) const;
  Progress report_backlash(ActiveCommand& command);
  // Into a copy, which counts only where all of the line is accepted.
  motion::Accepted change_for_all(motion::Limits& changed, const ActiveCommand& command,
                                  std::span<const Setting> settings) const;
  template <class Quantity>
  motion::Accepted change_per_axis(motion::Limits& changed, const ActiveCommand& command,
                                   SetOfAxis<Quantity> set) const;
  Progress set_limits(ActiveCommand& command, const motion::Limits& changed,
                      motion::Accepted accepted);

  static const Settings settings_;

  const MachineDescription& machine_;
  MotionTask& motion_;
  Coordinates& coordinates_;
  FilamentCommands* filament_;
};

}  // namespace application
