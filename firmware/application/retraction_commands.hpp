// SPDX-License-Identifier: Apache-2.0
// G10 and G11: filament is drawn back and pushed forward again as M207 and M208 say, and Z is
// lifted meanwhile. The host's coordinates do not show it. After M209 S1 G0 and G1 too.
#pragma once

#include <array>
#include <cstdint>

#include "application/active_command.hpp"
#include "application/coordinates.hpp"
#include "application/heat_task.hpp"
#include "application/motion_commands.hpp"
#include "application/motion_task.hpp"

namespace application {

class RetractionCommands {
 public:
  RetractionCommands(MotionTask& motion, HeatTask& heat, MotionCommands& moves,
                     Coordinates& coordinates)
      : motion_(motion), heat_(heat), moves_(moves), coordinates_(coordinates) {
    moves.respect(lift_);
  }

  // First the filament, then Z. A line beyond the travel of Z is refused as a whole.
  Progress retract(ActiveCommand& command);
  // First Z, with whichever tool it was lifted, to where the host's coordinate says that it is,
  // then the filament. After a stop Z is not lowered, since it need not have got there: its
  // coordinate becomes higher by the lift instead, unless homing or G92 has set it.
  Progress recover(ActiveCommand& command);
  // G0 and G1: one of the above where M209 says so, or a move. The host's E then shows what it has
  // asked for.
  Progress move(ActiveCommand& command);

 private:
  // `done` where the moves may follow.
  Progress begin(ActiveCommand& command, bool extrudes = true);
  Progress append(ActiveCommand& command, units::Axis axis, units::Nanometers distance,
                  units::MicrometersPerSecond speed);
  Progress lift(ActiveCommand& command, units::Nanometers distance);
  bool jumped() const { return motion_.position_jumps() != lift_.jumps; }
  void drop_void_lift();

  MotionTask& motion_;
  HeatTask& heat_;
  MotionCommands& moves_;
  Coordinates& coordinates_;
  // Of each tool.
  struct State {
    bool retracted{};
    units::Nanometers length{};  // that is drawn back
  };
  State& state() { return states_[coordinates_.tool()]; }
  std::array<State, units::most_tools> states_{};
  // Of Z, which all tools have in common.
  MotionCommands::Lift lift_{};
  bool recovers_{};  // the line in hand, which stands for G10 or G11
};

}  // namespace application
