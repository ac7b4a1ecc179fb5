// SPDX-License-Identifier: Apache-2.0
// The commands that lead to places of the machine: G27 G60 G61, and M290, which moves Z under the
// host's coordinates.
#pragma once

#include <array>
#include <cstdint>

#include "application/active_command.hpp"
#include "application/coordinates.hpp"
#include "application/motion_commands.hpp"
#include "application/motion_task.hpp"

namespace application {

class PlaceCommands {
 public:
  PlaceCommands(MotionTask& motion, MotionCommands& moves, Coordinates& coordinates)
      : motion_(motion), moves_(moves), coordinates_(coordinates) {}

  static constexpr std::int32_t slots = 2;  // of G60

  // G27: first Z, then X and Y at once, to 10 mm from the left and from the back as in Marlin. P0
  // lifts Z to 20 mm where it is lower, P1 leads it there, P2 lifts it by 20 mm, as far as it can.
  Progress park(ActiveCommand& command);
  Progress save_position(ActiveCommand& command);
  // G61: straight back, on the axes named or on X, Y and Z. E only gets its coordinate back.
  Progress restore_position(ActiveCommand& command);
  // M290: at once where nothing is planned, otherwise within the next line that moves X or Y.
  Progress step_baby(ActiveCommand& command);
  Progress report_babystep(ActiveCommand& command);

 private:
  Progress append(ActiveCommand& command, const Positions& machine,
                  units::MicrometersPerSecond feedrate);

  MotionTask& motion_;
  MotionCommands& moves_;
  Coordinates& coordinates_;
  // In the host's coordinates without what shifts them, so without the lift of G10 and baby steps.
  std::array<Positions, slots> places_{};
  std::uint8_t saved_{};  // a bit for each slot
  std::uint32_t jumps_{};  // of the position, when parking began
};

}  // namespace application
