// SPDX-License-Identifier: Apache-2.0
// The commands for heaters and fan: M104 M106 M107 M109 M140 M149 M190 M302.
#pragma once

#include "application/active_command.hpp"
#include "application/heat_task.hpp"
#include "application/timer_commands.hpp"
#include "drivers/fan.hpp"

namespace application {

class HeatCommands {
 public:
  HeatCommands(HeatTask& heat, drivers::Fan& fan, TimerCommands& timer)
      : heat_(heat), fan_(fan), timer_(timer) {}

  Progress set_temperature(ActiveCommand& command, Heater heater);
  Progress set_and_wait(ActiveCommand& command, Heater heater);
  // M149: the unit of temperatures in commands. Reports stay in °C, as in Marlin.
  Progress set_units(ActiveCommand& command);
  Progress report_units(ActiveCommand& command);
  // M302: S is the temperature below which the extruder does not turn, P1 allows it to turn cold.
  Progress set_extrusion_limit(ActiveCommand& command);
  Progress report_extrusion_limit(ActiveCommand& command);
  Progress set_fan(ActiveCommand& command);
  Progress stop_fan(ActiveCommand& command);

 private:
  enum class Unit : std::uint8_t { celsius, fahrenheit, kelvin };

  Heater heater_of(const ActiveCommand& command, Heater heater) const;
  bool names_no_hotend(const ActiveCommand& command, Heater heater) const;
  units::Millicelsius temperature_of(std::int64_t millionths) const;
  // Sets it, or refuses it.
  Progress take_target(ActiveCommand& command, Heater heater, std::int64_t millionths);
  // S waits only for heating, R for cooling too.
  Progress begin_to_wait(ActiveCommand& command, Heater heater);

  HeatTask& heat_;
  drivers::Fan& fan_;
  TimerCommands& timer_;
  units::Milliseconds next_report_{};  // while a heater is waited for
  Unit unit_{};
};

}  // namespace application
