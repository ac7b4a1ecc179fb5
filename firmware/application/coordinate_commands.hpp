// SPDX-License-Identifier: Apache-2.0
// What numbers mean: G17 to G21 G54 to G59.3 G90 G91 G92 M82 M83 M200 M206 M428.
#pragma once

#include "application/active_command.hpp"
#include "application/coordinates.hpp"
#include "application/motion_task.hpp"

namespace application {

class CoordinateCommands {
 public:
  CoordinateCommands(MotionTask& motion, Coordinates& coordinates)
      : motion_(motion), coordinates_(coordinates) {}

  Progress set_inches(ActiveCommand&, bool inches) {
    coordinates_.set_inches(inches);
    return Progress::done;
  }
  Progress set_relative(ActiveCommand&, bool relative) {
    coordinates_.set_relative(relative);
    return Progress::done;
  }
  Progress set_extruder_relative(ActiveCommand&, bool relative) {
    coordinates_.set_extruder_relative(relative);
    return Progress::done;
  }
  Progress set_plane(ActiveCommand&, motion::Plane plane) {
    coordinates_.set_plane(plane);
    return Progress::done;
  }
  // G92, G92.1.
  Progress set_position(ActiveCommand& command);
  // G54 to G58 are the systems 0 to 4, G59 to G59.3 the others.
  Progress select_system(ActiveCommand& command, std::size_t system);
  Progress set_filament(ActiveCommand& command);
  Progress report_filament(ActiveCommand& command);
  Progress set_home_offset(ActiveCommand& command);
  Progress report_home_offset(ActiveCommand& command);
  // M428: the present place is the end of the axes' travel that is nearer.
  Progress take_home_offset(ActiveCommand& command);

 private:
  MotionTask& motion_;
  Coordinates& coordinates_;
};

}  // namespace application
