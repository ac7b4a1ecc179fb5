// SPDX-License-Identifier: Apache-2.0
// The commands that move, stop or switch motors: G0 G1 G4 G28 M17 M18 M84 M400 M410.
#pragma once

#include "application/active_command.hpp"
#include "application/coordinates.hpp"
#include "application/heat_task.hpp"
#include "application/motion_task.hpp"

namespace application {

class MotionCommands {
 public:
  MotionCommands(MotionTask& motion, HeatTask& heat, Coordinates& coordinates)
      : motion_(motion), heat_(heat), coordinates_(coordinates) {}

  Progress move(ActiveCommand& command);
  Progress dwell(ActiveCommand& command);
  Progress home(ActiveCommand& command);
  Progress switch_on(ActiveCommand& command);
  Progress switch_off(ActiveCommand& command);
  Progress quick_stop(ActiveCommand& command);

  // M84 S: after how long at rest the motors are switched off; 0 is never.
  units::Milliseconds motor_timeout() const { return motor_timeout_; }

 private:
  Progress append(ActiveCommand& command);
  Progress switch_motors(const ActiveCommand& command, bool enabled);

  MotionTask& motion_;
  HeatTask& heat_;
  Coordinates& coordinates_;
  units::AxisSet homing_axes_;
  units::Milliseconds dwell_end_{};
  units::Milliseconds motor_timeout_{};
};

}  // namespace application
