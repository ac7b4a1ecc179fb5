// SPDX-License-Identifier: Apache-2.0
// Probe and mesh of an uneven bed: G29 G30 M420 M421 M851.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "application/active_command.hpp"
#include "application/coordinates.hpp"
#include "application/motion_task.hpp"

namespace application {

class LevellingCommands {
 public:
  LevellingCommands(MotionTask& motion, const Coordinates& coordinates)
      : motion_(motion), coordinates_(coordinates) {}

  // Each of them. One for all, a part of the image's main.cpp: without a probe nothing is left of
  // the others.
  Progress execute(ActiveCommand& command);

 private:
  Progress execute_fitted(ActiveCommand& command);

  // G29 and G30
  Progress probe_bed(ActiveCommand& command);
  Progress begin_grid(ActiveCommand& command);
  Progress begin_point(ActiveCommand& command);
  Progress end_grid(ActiveCommand& command);
  Progress probe_place(ActiveCommand& command);
  std::optional<std::string_view> take_grid(const gcode::Command& command,
                                            std::array<motion::MeshAxis, 2>& axes) const;
  Positions above(units::Nanometers x, units::Nanometers y) const;
  bool reaches(const Positions& from, const Positions& nozzle) const;
  std::optional<Progress> refuse_unreached(ActiveCommand& command,
                                           const std::array<motion::MeshAxis, 2>& axes) const;
  std::optional<Progress> refuse_to_probe(ActiveCommand& command) const;
  // Nothing where there is a height.
  std::optional<Progress> failure(ActiveCommand& command) const;
  // After a stop motors may have lost steps.
  std::optional<Progress> refuse_after_stop(ActiveCommand& command) const;
  std::size_t points(std::size_t axis) const { return motion_.levelling().mesh.points(axis); }
  // Of the point in turn: there and back.
  std::size_t row() const { return point_ / points(0); }
  std::size_t column() const;

  // M420, M421, M851
  Progress set_mesh(ActiveCommand& command);
  Progress set_point(ActiveCommand& command);
  Progress set_offset(ActiveCommand& command);
  Progress report_mesh_use(ActiveCommand& command);
  Progress refuse_to_follow(ActiveCommand& command);
  Progress say_mesh(ActiveCommand& command);
  std::optional<units::Nanometers> machine_length(const gcode::Command& command, char letter,
                                                  units::Axis axis) const;

  MotionTask& motion_;
  const Coordinates& coordinates_;
  std::size_t point_{};  // of the grid, in order of probing
  bool point_begun_{};
};

}  // namespace application
