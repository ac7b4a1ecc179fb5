// SPDX-License-Identifier: Apache-2.0
// The commands for two tools: T M217 M218 M605.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "application/active_command.hpp"
#include "application/coordinates.hpp"
#include "application/heat_task.hpp"
#include "application/motion_commands.hpp"
#include "application/motion_task.hpp"

namespace application {

class ToolCommands {
 public:
  ToolCommands(const MachineDescription& machine, MotionTask& motion, HeatTask& heat,
               MotionCommands& moves, Coordinates& coordinates) {
    motion_.fill(&motion);
    heat_.fill(&heat);
    moves_.fill(&moves);
    coordinates_.fill(&coordinates);
    coordinates.restore_tools(machine);
  }

  // The new nozzle goes to the place of the old one, so that the host's coordinates stay: unless S1
  // is given, an axis is not homed or the way there is out of reach, when it stays where it is and
  // the coordinates change. T of the tool in use brings filament forward that a change has left.
  Progress select(ActiveCommand& command);
  // M217: what happens then; Q extrudes as much as E says.
  Progress set_change(ActiveCommand& command);
  // M218.
  Progress set_offset(ActiveCommand& command);
  Progress report_offset(ActiveCommand& command);
  // M605: S0 and S1 are what there is, one tool at a time.
  Progress set_mode(ActiveCommand& command);

 private:
  // A change in its order. Each move ends before the next step begins.
  enum class Step : std::uint8_t {
    retract,  // the old filament
    lift,
    select,
    unretract,  // the new filament
    prime,
    travel,  // X and Y
    lower,
    resume,
    done,
  };
  struct Change {
    Step step{Step::done};
    bool moves{};
    bool resumes{};  // filament that has come back gets some more
    std::uint32_t jumps{};  // of the position, when it began
    // Of the machine: where the new nozzle is at the place of the old one.
    Positions target{};
    units::Position height{};  // of Z, meanwhile
    units::MicrometersPerSecond feedrate{};
    // Of each tool: what a change has drawn back.
    std::array<units::Nanometers, units::most_tools> drawn{};
    // When the move under way began, which draws back or pushes: what was drawn, and E; the host's.
    bool pushes{};
    units::Nanometers drawn_before{};
    units::Position extruder{}, logical_extruder{};
    std::optional<motion::Fault> fault;  // of a move that was refused
  };

  void begin(ActiveCommand& command);
  void plan(std::size_t tool);
  // A move has begun.
  bool carry_out(Step step, std::size_t tool);
  bool extrude(units::Nanometers length, units::MicrometersPerSecond speed);
  bool push(std::size_t tool, units::Nanometers length, units::MicrometersPerSecond speed);
  bool way_is_free();
  void note_stop();
  Progress report_end(ActiveCommand& command, std::size_t tool);
  bool go_to(const Positions& machine, units::MicrometersPerSecond feedrate);
  Progress prime(ActiveCommand& command);
  Change& change() { return change_[0]; }

  MotionTask& motion() { return *motion_[0]; }
  HeatTask& heat() { return *heat_[0]; }
  MotionCommands& moves() { return *moves_[0]; }
  Coordinates& coordinates() { return *coordinates_[0]; }
  // Of a machine with one tool nothing is known here.
  std::size_t count() { return units::most_tools == 1 ? 1 : coordinates().tools().count(); }

  [[no_unique_address]] units::IfTwoTools<MotionTask*> motion_{};
  [[no_unique_address]] units::IfTwoTools<HeatTask*> heat_{};
  [[no_unique_address]] units::IfTwoTools<MotionCommands*> moves_{};
  [[no_unique_address]] units::IfTwoTools<Coordinates*> coordinates_{};
  [[no_unique_address]] units::IfTwoTools<Change> change_{};
};

}  // namespace application
