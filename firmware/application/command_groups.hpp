// SPDX-License-Identifier: Apache-2.0
// All commands, a class for each group, with what they share.
#pragma once

#include <tuple>

#include "application/coordinate_commands.hpp"
#include "application/dry_run_commands.hpp"
#include "application/factor_commands.hpp"
#include "application/filament_commands.hpp"
#include "application/file_commands.hpp"
#include "application/heat_commands.hpp"
#include "application/host_commands.hpp"
#include "application/levelling_commands.hpp"
#include "application/motion_commands.hpp"
#include "application/place_commands.hpp"
#include "application/report_commands.hpp"
#include "application/retraction_commands.hpp"
#include "application/setting_commands.hpp"
#include "application/shaping_commands.hpp"
#include "application/timer_commands.hpp"
#include "application/tool_commands.hpp"

namespace application {

struct CommandGroups {
  CommandGroups(const MachineDescription& machine, MotionTask& motion_task, HeatTask& heat_task,
                drivers::Fan& fan, host_link::HostLink& link, const Statistics& counters,
                FilamentCommands* filament)
      : motion(motion_task, heat_task, coordinates),
        retraction(motion_task, heat_task, motion, coordinates),
        places(motion_task, motion, coordinates),
        tools(machine, motion_task, heat_task, motion, coordinates),
        modes(motion_task, coordinates),
        settings(machine, motion_task, coordinates, filament),
        shaping(motion_task),
        factors(motion_task, coordinates),
        heat(heat_task, fan, timer),
        reports(machine, motion_task, heat_task, coordinates, counters),
        host(link, machine.host_silence),
        levelling(motion_task, coordinates),
        filament_(filament) {
    if (handles_filament()) {
      filament_->attach(machine, motion_task, heat_task, motion, coordinates, timer);
    }
  }
  // The groups refer to the coordinates.
  CommandGroups(const CommandGroups&) = delete;
  CommandGroups& operator=(const CommandGroups&) = delete;

  template <class Group>
  Group& of() {
    return std::get<Group&>(std::tie(motion, retraction, places, tools, modes, settings, shaping,
                                     factors, timer, heat, reports, host, levelling, files,
                                     dry_runs));
  }

  // There is a sensor, or a way to load it.
  // Inlined for certain, so that link-time optimisation drops what depends on it.
  [[gnu::always_inline]] bool handles_filament() const {
    return filament_in_image && filament_ != nullptr;
  }
  // Only where it does.
  FilamentCommands& filament() { return *filament_; }

  Coordinates coordinates;
  MotionCommands motion;
  RetractionCommands retraction;
  PlaceCommands places;
  [[no_unique_address]] ToolCommands tools;
  CoordinateCommands modes;
  SettingCommands settings;
  ShapingCommands shaping;
  FactorCommands factors;
  TimerCommands timer;
  HeatCommands heat;
  ReportCommands reports;
  HostCommands host;
  LevellingCommands levelling;
  FileCommands files;
  DryRunCommands dry_runs;

 private:
  FilamentCommands* filament_;
};

// How the executor calls what carries a command out.
using Handler = Progress (*)(CommandGroups&, ActiveCommand&);

// M412, M603, M701 and M702.
inline Progress execute_of_filament(CommandGroups& groups, ActiveCommand& command) {
  return groups.handles_filament() ? groups.filament().execute(command)
                                   : command.report_not_fitted();
}

template <class Group, class... Constants>
Group group_of(Progress (Group::*)(ActiveCommand&, Constants...));

// The method of a group, with constants after the command.
template <auto method, auto... constants>
Progress handler(CommandGroups& groups, ActiveCommand& command) {
  using Group = decltype(group_of(method));
  return (groups.of<Group>().*method)(command, constants...);
}

}  // namespace application
