// SPDX-License-Identifier: Apache-2.0
// The firmware from the host link to the driver of the step generator, with a model of motion
// behind its bus and time that leaps from one event to the next.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>

#include "application/command_executor.hpp"
#include "application/statistics.hpp"
#include "tools/planning/motion_model.hpp"
#include "tools/planning/plan.hpp"

namespace planning {

class PrintPlanner {
 public:
  // For the machine of the build, or for another one, whose name outlives this.
  explicit PrintPlanner(std::uint32_t clock_hz);
  PrintPlanner(const application::MachineDescription& machine, std::uint32_t clock_hz);

  // Executes a line of the file; false where it ends the print.
  bool take(std::size_t file_line, std::string_view text);
  // Each line of the step generator, in its order, as soon as it is made.
  void on_line(std::function<void(const Walk&)> take) { model_.on_line = std::move(take); }
  // How many of them are made or planned.
  std::uint64_t planned_lines() const {
    return model_.lines() + motion::Planner::capacity - motion_.room();
  }
  std::array<double, 3> steps_per_mm() const;

  // What is planned is executed. To be called once, at the end.
  Plan finish();

 private:
  void pass();
  void leap();
  void go_on(double seconds);
  void collect_replies();
  void refuse(std::size_t file_line, std::string_view text, std::string_view reason);

  double clock_hz_;
  application::MachineDescription machine_;
  MotionModel model_;
  application::Statistics statistics_{};
  drivers::StepGenerator step_generator_;
  drivers::EndStops end_stops_;
  drivers::TemperatureConverter converter_;
  drivers::HeaterControl heater_control_;
  drivers::Fan fan_;
  motion::Shaping shaping_;
  motion::Levelling levelling_;
  motion::Backlash backlash_;
  application::FilamentCommands filament_;
  application::MotionTask motion_;
  application::HeatTask heat_;
  host_link::HostLink link_;
  application::CommandExecutor executor_;
  double started_{};
  application::Now now_;
  std::string replies_;
  Plan plan_;
};

}  // namespace planning
