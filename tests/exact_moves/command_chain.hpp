// SPDX-License-Identifier: Apache-2.0
// The firmware from the line to the segment (host link, parser, executor, planner, driver) with a
// step counter where the step generator would be.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "application/command_executor.hpp"
#include "tests/exact_moves/exact_axes.hpp"

namespace exact_moves {

// Behind the bus: executes each segment the moment it is committed, and has a hot nozzle.
class StepCounter {
 public:
  StepCounter();
  ~StepCounter();
  StepCounter(const StepCounter&) = delete;
  StepCounter& operator=(const StepCounter&) = delete;

  std::uint32_t read(std::uint32_t address);
  void write(std::uint32_t address, std::uint32_t value);
  // A temperature conversion ends.
  void convert() { ++conversions_; }

  std::array<std::int64_t, axis_count> steps{};
  // Lines whose segments do not add up to them.
  std::uint64_t broken_lines{};

 private:
  void commit();

  std::map<std::uint32_t, std::uint32_t> words_;
  std::uint32_t ticks_left_{};
  std::uint32_t conversions_{};
};

class CommandChain {
 public:
  explicit CommandChain(const std::array<std::int32_t, axis_count>& steps_per_meter);

  // Executes a line; what was said other than the ok is kept in `notices`.
  void take(std::string_view line);
  // Executes what is planned.
  void settle() { take("M400"); }

  const std::array<std::int64_t, axis_count>& steps() const { return counter_.steps; }
  std::uint64_t broken_lines() const { return counter_.broken_lines; }
  std::string notices;

 private:
  void pass();
  void collect_replies();

  StepCounter counter_;
  application::MachineDescription machine_;
  application::Statistics statistics_{};
  drivers::StepGenerator step_generator_;
  drivers::EndStops end_stops_;
  drivers::TemperatureConverter converter_;
  drivers::HeaterControl heater_control_;
  drivers::Fan fan_;
  application::MotionTask motion_;
  application::HeatTask heat_;
  host_link::HostLink link_;
  application::CommandExecutor executor_;
  application::Now now_;
  std::string replies_;
};

}  // namespace exact_moves
