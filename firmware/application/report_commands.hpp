// SPDX-License-Identifier: Apache-2.0
// The commands that report: M105 M114 M115 M119 M122, and how often unasked: M154 M155.
#pragma once

#include "application/active_command.hpp"
#include "application/coordinates.hpp"
#include "application/heat_task.hpp"
#include "application/machine_description.hpp"
#include "application/motion_task.hpp"
#include "application/statistics.hpp"

namespace application {

class ReportCommands {
 public:
  ReportCommands(const MachineDescription& machine, MotionTask& motion, HeatTask& heat,
                 const Coordinates& coordinates, const Statistics& counters)
      : machine_(machine),
        motion_(motion),
        heat_(heat),
        coordinates_(coordinates),
        counters_(counters) {}

  Progress report_temperature(ActiveCommand& command) {
    return say_temperature(command, command.now.milliseconds);
  }
  Progress report_position(ActiveCommand& command) { return say_position(command); }
  Progress report_firmware(ActiveCommand& command) { return say_firmware(command); }
  Progress report_end_stops(ActiveCommand& command);
  Progress report_tasks(ActiveCommand& command);
  Progress set_position_interval(ActiveCommand& command);
  Progress set_temperature_interval(ActiveCommand& command);

  // M105, M114 or M115 ahead of the line in hand, unless it must wait for a temperature.
  bool must_wait(std::uint8_t code, units::Milliseconds now) const {
    return code == 105 && first_temperatures_awaited(now);
  }
  Progress answer_ahead(std::uint8_t code, Reply& reply, units::Milliseconds now);
  // The first conversions take some 100 ms; before them a temperature would be 0.
  bool first_temperatures_awaited(units::Milliseconds now) const;

  // How often they are reported unasked; 0 is never.
  units::Milliseconds position_interval() const { return position_interval_; }
  units::Milliseconds temperature_interval() const { return temperature_interval_; }
  host_link::TextLine position_line() const;
  host_link::TextLine temperature_line() const;

 private:
  Progress say_temperature(Reply& reply, units::Milliseconds now) const;
  Progress say_position(Reply& reply) const { return reply.say(position_line()); }
  Progress say_firmware(Reply& reply) const;
  Progress say_levelling(Reply& reply) const;

  const MachineDescription& machine_;
  MotionTask& motion_;
  HeatTask& heat_;
  const Coordinates& coordinates_;
  const Statistics& counters_;
  units::Milliseconds position_interval_{};
  units::Milliseconds temperature_interval_{};
};

}  // namespace application
