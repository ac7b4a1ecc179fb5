// SPDX-License-Identifier: Apache-2.0
// The sensor of the filament, and how it is loaded and unloaded: M412 M603 M701 M702. Only a
// machine that has one of both has the object.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "application/active_command.hpp"
#include "application/coordinates.hpp"
#include "application/heat_task.hpp"
#include "application/motion_commands.hpp"
#include "application/motion_task.hpp"
#include "application/timer_commands.hpp"

namespace application {

class FilamentCommands {
 public:
  // Before anything else. Everything handed over must outlive it.
  void attach(const MachineDescription& machine, MotionTask& motion, HeatTask& heat,
              MotionCommands& moves, Coordinates& coordinates, const TimerCommands& timer);

  // Each of them.
  Progress execute(ActiveCommand& command);

  // M501 and M502: as the machine description has them.
  void restore();
  // What M503 lists of it, line by line; nothing behind the last one.
  std::optional<host_link::TextLine> report(std::size_t index, bool inches) const;

  // Each pass. The filament has run out once the sensor has been without it for this time, while
  // the timer of the print runs. It may be away while it is loaded or unloaded, and from then on
  // until it is seen again or another print begins.
  static constexpr units::Milliseconds time_without{200};
  void watch(units::Milliseconds now);
  // It has, and what M600 does is due.
  bool has_run_out() const { return has_run_out_; }
  // What the sensor has seen is forgotten.
  void reset() {
    has_run_out_ = false;
    without_ = false;
  }
  // The print is cancelled: nothing is asked before the timer has stopped.
  void cancel() {
    reset();
    cancelled_ = true;
  }

 private:
  // One of the moves of M701 or M702, one after another.
  struct Move {
    units::Axis axis{};
    units::Nanometers distance{};
    units::MicrometersPerSecond speed{};
  };

  bool has_sensor() const { return machine_->filament_sensor != nullptr; }
  bool has_change() const { return machine_->filament_change != nullptr; }
  Progress set_sensor(ActiveCommand& command);
  Progress set_lengths(ActiveCommand& command);
  Progress move(ActiveCommand& command, bool loads);
  Progress begin(ActiveCommand& command, bool loads);
  Progress go_on();
  Progress end(ActiveCommand& command);
  host_link::TextLine lengths_report(std::size_t tool, bool inches) const;
  void note_stop();
  std::optional<Progress> plan(ActiveCommand& command, bool loads);

  const MachineDescription* machine_{};
  MotionTask* motion_{};
  HeatTask* heat_{};
  MotionCommands* moves_{};
  Coordinates* coordinates_{};
  const TimerCommands* timer_{};

  bool watches_{true};
  bool cancelled_{};
  bool without_{};
  bool has_run_out_{};
  units::Milliseconds without_since_{};
  // M701 or M702 is at work; the filament that it has drawn back has not been seen since.
  bool at_work_{};
  bool expected_{};
  // Of each tool.
  std::array<units::Nanometers, units::most_tools> load_{}, unload_{};
  std::array<Move, 4> plan_{};
  std::size_t next_{};  // of them
  std::string_view reason_{};  // why filament stays where it is; Z is lowered all the same
  std::uint32_t jumps_{};  // of the position, when they began
  units::Position extruder_{};  // as the host calls it, when they began
  units::Position height_shift_{};  // of the Z that the host knows from the machine's
};

}  // namespace application
