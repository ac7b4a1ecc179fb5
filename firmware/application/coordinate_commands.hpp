// SPDX-License-Identifier: Apache-2.0
// The commands that say what numbers mean: G17 to G21 G90 G91 G92 M82 M83.
#pragma once

#include "application/active_command.hpp"
#include "application/coordinates.hpp"

namespace application {

class CoordinateCommands {
 public:
  explicit CoordinateCommands(Coordinates& coordinates) : coordinates_(coordinates) {}

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
  Progress set_position(ActiveCommand& command);

 private:
  Coordinates& coordinates_;
};

}  // namespace application
