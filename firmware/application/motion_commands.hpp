// SPDX-License-Identifier: Apache-2.0
// The commands that move, stop or switch motors: G0 to G4 G28 M17 M18 M84 M211 M400 M410.
#pragma once

#include <cstdint>
#include <optional>

#include "application/active_command.hpp"
#include "application/coordinates.hpp"
#include "application/heat_task.hpp"
#include "application/motion_task.hpp"
#include "motion/arc.hpp"

namespace application {

class MotionCommands {
 public:
  MotionCommands(MotionTask& motion, HeatTask& heat, Coordinates& coordinates)
      : motion_(motion), heat_(heat), coordinates_(coordinates) {}

  Progress move(ActiveCommand& command);
  Progress arc(ActiveCommand& command, bool clockwise);
  Progress dwell(ActiveCommand& command);
  Progress home(ActiveCommand& command);
  Progress switch_on(ActiveCommand& command);
  Progress switch_off(ActiveCommand& command);
  Progress quick_stop(ActiveCommand& command);

  // M211: whether a target beyond the travel of a homed axis is refused.
  Progress set_soft_limits(ActiveCommand& command);
  Progress report_soft_limits(ActiveCommand& command);

  // Nothing where the machine may go there.
  std::optional<Progress> refuse_beyond_limits(ActiveCommand& command, const Positions& machine);

  // Whether it may, without a word.
  bool may_go_to(const Positions& machine) const;

  // How much G10 has lifted Z, until G11 or a jump of the position. Soft limits hold for the
  // lowered nozzle too, so that G11 can always lower it.
  struct Lift {
    units::Nanometers height{};
    std::uint32_t jumps{};  // of the position, when Z was lifted
  };
  void respect(const Lift& lift) { lift_ = &lift; }

  // M84 S: after how long at rest the motors are switched off; 0 is never.
  units::Milliseconds motor_timeout() const { return motor_timeout_; }

 private:
  Progress append(ActiveCommand& command);
  bool takes_babystep(const Positions& machine) const;
  // Where a line leads: what the host believes then, and where the machine is. Nothing where the
  // line is not refused, and need not wait.
  std::optional<Progress> take_target(ActiveCommand& command, Positions& logical,
                                      Positions& machine);
  Progress begin_arc(ActiveCommand& command, bool clockwise);
  std::optional<Progress> take_centre(ActiveCommand& command, motion::ArcRequest& request);
  Progress append_first_chord(ActiveCommand& command);
  Progress append_chord(ActiveCommand& command);
  Progress switch_motors(const ActiveCommand& command, bool enabled);
  std::optional<units::Axis> axis_out_of_bounds(const Positions& machine) const;

  MotionTask& motion_;
  HeatTask& heat_;
  Coordinates& coordinates_;
  motion::Arc arc_;
  units::MicrometersPerSecond arc_feedrate_{}, feedrate_before_arc_{};
  std::uint32_t arc_jumps_{};  // of the position, when the arc began
  std::optional<motion::Fault> arc_fault_;  // of a chord that was refused
  units::AxisSet homing_axes_;
  units::Milliseconds dwell_end_{};
  units::Milliseconds motor_timeout_{};
  bool soft_limits_{true};
  const Lift* lift_{};
};

}  // namespace application
