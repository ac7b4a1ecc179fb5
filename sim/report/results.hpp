// SPDX-License-Identifier: Apache-2.0
// The contents of a print's report, as plain values.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/report/axis_courses.hpp"
#include "sim/report/chip_record.hpp"
#include "sim/report/findings.hpp"
#include "sim/report/message_log.hpp"
#include "sim/report/requested_path.hpp"
#include "sim/report/step_statistics.hpp"
#include "sim/report/task_result.hpp"
#include "sim/report/temperature_record.hpp"
#include "sim/report/tool_path.hpp"

namespace report {

enum class Outcome : std::uint8_t { completed, faulted, stopped };

struct AxisResult {
  std::uint64_t steps_forward{};
  std::uint64_t steps_backward{};
  std::int64_t final_position_steps{};
  double final_position_mm{};
  double max_step_rate_hz{};
  std::uint64_t illegal_pulses{};
  std::uint64_t disabled_pulses{};
  std::uint64_t slipped_steps{};
  std::uint64_t frame_steps{};
  std::uint64_t unasked_steps{};  // beyond those between the points that were reached
  double peak_load{};
};

struct FirmwareResult {
  std::uint64_t text_bytes{};
  std::uint64_t data_bytes{};
  std::uint64_t bss_bytes{};
  std::uint64_t stack_peak_bytes{};
};

struct Results {
  std::string file;
  std::string machine;
  Outcome outcome = Outcome::faulted;
  std::string fault;  // empty unless faulted
  std::uint32_t clock_hz{};
  std::uint64_t cycles{};
  double simulated_seconds{};
  double wall_seconds{};
  std::uint64_t lines_sent{};
  std::uint64_t resends{};
  std::uint64_t commands_executed{};
  std::uint64_t commands_refused{};
  std::uint64_t busy_replies{};
  std::size_t motors = 4;  // x y z e, and where there is one that of a second extruder
  std::array<AxisResult, motor_count> axes{};
  double max_deviation_mm{};
  double length_mm{};
  double max_deviation_steps{};  // the same in steps of the coarser of X and Y
  std::uint64_t points_reached{};
  std::uint64_t points_missed{};
  // Of the points reached, while input shaping or linear advance was on: to the step only where the
  // machine came to rest; and how far the tool was off the lines then.
  std::uint64_t points_shaped{};
  double max_shaping_mm{};
  std::uint64_t underruns{};
  std::uint64_t late_ticks{};  // only where software makes the steps
  std::uint64_t guard_stalls_cycles{};
  std::uint64_t max_queue_depth{};
  TemperatureResult hotend{};
  TemperatureResult bed{};
  TemperatureResult second_hotend{};  // where there is one
  FirmwareResult firmware;
  double processor_busy_percent{};
  double moving_seconds{};
  double processor_saturated_seconds{};  // of those, in which it hardly slept
  std::uint64_t instructions{};
  std::vector<TaskResult> tasks;  // of the firmware's loop; empty of another program
  std::uint64_t longest_pass_clocks{};  // of the firmware's loop, from waking up to sleeping
  std::uint64_t other_programs{};  // that took the firmware's place
  std::uint64_t gaps{};  // in what is known of the lines that the firmware took
  std::uint64_t serial_bytes_corrupted{};
  std::vector<Message> messages;
  std::uint64_t messages_dropped{};
  Findings findings;

  // Exactly the motion that the file requests was made.
  bool good() const { return findings.problems.empty(); }
};

// The limits of an axis by the machine description.
struct AxisLimits {
  double steps_per_mm{};
  double speed_mm_s{};
  double acceleration_mm_s2{};
  double jerk_mm_s{};  // a jump of speed at a corner
};

// Data for the pictures only.
struct Courses {
  std::vector<ToolPoint> path;
  std::vector<RequestedMove> asked;
  std::vector<TemperatureSample> hotend;
  std::vector<TemperatureSample> bed;
  std::array<AxisCourse, AxisCourses::axes> axes;
  std::array<AxisLimits, AxisCourses::axes> limits{};
  ChipCourse chip;
  std::array<StepStatistics::Histogram, AxisCourses::axes> intervals{};
};

constexpr const char* name_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::completed:
      return "completed";
    case Outcome::faulted:
      return "faulted";
    case Outcome::stopped:
      return "stopped";
  }
  return "";
}

inline constexpr std::array<const char*, motor_count> axis_names{"x", "y", "z", "e", "e1"};
inline constexpr std::array<const char*, motor_count> axis_titles{"X", "Y", "Z", "E", "E1"};

}  // namespace report
