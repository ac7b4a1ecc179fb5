// SPDX-License-Identifier: Apache-2.0
// The commands that scale what lines request: M220 (speed) and M221 (filament).
#pragma once

#include "application/active_command.hpp"
#include "application/coordinates.hpp"
#include "application/motion_task.hpp"

namespace application {

class FactorCommands {
 public:
  FactorCommands(MotionTask& motion, Coordinates& coordinates)
      : motion_(motion), coordinates_(coordinates) {}

  Progress set_speed(ActiveCommand& command);
  Progress report_speed(ActiveCommand& command);
  Progress set_flow(ActiveCommand& command);
  Progress report_flow(ActiveCommand& command);

  // M220 of a person in the middle of a job.
  void set_speed_at_once(std::int32_t percent);

 private:
  MotionTask& motion_;
  Coordinates& coordinates_;
  std::int32_t kept_speed_{100};  // M220 B
};

}  // namespace application
