// SPDX-License-Identifier: Apache-2.0
// The sensor of the filament, and how it is loaded and unloaded: M412 M603 M701 M702. Only a
// machine that has one of both has the object.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

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

  // Each pass. The filament has run out once the sensor has been without it for this time, while
  // the timer of the print runs.
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
  units::Nanometers load_{}, unload_{};
  std::array<Move, 4> plan_{};
  std::size_t next_{};  // of them
  std::uint32_t jumps_{};  // of the position, when they began
  units::Position extruder_{};  // as the host calls it, when they began
  units::Position height_shift_{};  // of the Z that the host knows from the machine's
};

}  // namespace application
