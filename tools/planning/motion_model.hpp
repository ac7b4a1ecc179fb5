// SPDX-License-Identifier: Apache-2.0
// Step generator and end stops at the level of registers: executes whole segments in calculated
// time, and records what they ask of the axes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>

#include "machine/kinematics.hpp"
#include "motion/limits.hpp"
#include "tools/planning/path.hpp"
#include "tools/planning/plan.hpp"

namespace planning {

class MotionModel {
 public:
  // Axes with an end stop stand this far from it.
  static constexpr double start_mm = 20.0;

  MotionModel(const motion::Limits& limits, const motion::kinematics::Any& kinematics,
              double clock_hz);
  ~MotionModel();
  MotionModel(const MotionModel&) = delete;
  MotionModel& operator=(const MotionModel&) = delete;

  // The firmware's bus.
  std::uint32_t read(std::uint32_t address);
  void write(std::uint32_t address, std::uint32_t value);

  // M92 and the kinematics' settings hold for the records from now on.
  void set_steps_per_mm(const motion::Limits& limits);
  // On an input of the end stops, triggered with the nozzle up to this height above an even bed.
  // For machines with a motor of Z alone.
  void fit_probe(std::uint8_t input, units::Nanometers height);
  void set_kinematics(const motion::kinematics::Any& kinematics) { kinematics_ = kinematics; }

  // Called after each line that the step generator executes.
  std::function<void(const Walk&)> on_line;
  const std::array<double, motor_count>& steps_per_mm() const { return steps_per_mm_; }

  void advance(double clocks) { now_ += clocks; }
  double now() const { return now_; }
  // When what is queued will have been executed, and the segment under way.
  double queue_end() const { return queue_end_; }
  double segment_end() const;
  bool queue_full() { return level() == queue_depth; }

  const std::array<AxisPlan, motor_count>& axes() const { return axes_; }
  // Without the last layer's end.
  const std::deque<Layer>& layers() const { return layers_; }
  double moving_clocks() const { return moving_clocks_; }
  double first_step() const { return first_step_; }
  // Of each tool.
  const std::array<double, 2>& filament_mm() const { return filament_mm_; }
  std::uint64_t lines() const { return lines_; }
  std::uint64_t underruns() const { return underruns_; }

 private:
  struct Line {
    std::array<std::int64_t, motor_count> steps{};
    double ticks{};
    double ticks_done{};
    double last_tick{};  // an end stop ends the line there
    std::uint32_t stop_mask{};
  };

  static constexpr std::size_t queue_depth = 32;
  static constexpr std::size_t words_of_peripheral = 1024;
  static constexpr double never = 1e300;

  std::uint32_t read_generator(std::uint32_t address);
  std::uint32_t word(std::uint32_t address) const {
    return words_[address / 4 % words_of_peripheral];
  }
  double wide(std::uint32_t low, std::uint32_t high) const;
  std::uint32_t count_of(double ohms) const;  // of the temperature converter
  std::size_t level();
  bool stopped() const { return stop_time_ <= now_; }
  std::uint32_t closed_end_stops() const;
  double tick_of_stop(const Line& line) const;
  void place_end_stops(const motion::Limits& limits);
  std::int64_t approach_of(std::size_t axis,
                           const std::array<std::int64_t, motor_count>& steps) const;
  std::array<double, 3> place_mm() const;
  void command(std::uint32_t value);
  void commit();
  void begin_line(std::uint32_t backward, std::uint32_t stop_mask);
  void record_layer(double begin);
  void record_peaks(double rate, double end_rate, double acceleration, double scale);
  void count_steps();

  motion::kinematics::Any kinematics_;
  double clock_hz_;
  std::array<std::uint32_t, words_of_peripheral> words_{};  // of the step generator
  std::array<double, motor_count> steps_per_mm_{};
  std::array<std::uint32_t, motor_count> end_stop_{};  // mask of its input, or none
  // How much nearer to the axis' end stop a step of each motor brings it.
  std::array<std::array<std::int64_t, motor_count>, motor_count> towards_{};
  std::uint32_t probe_{};  // mask of its input, or none
  std::int64_t probe_distance_{};  // of Z, where it triggers
  std::array<std::int64_t, motor_count> distance_{};  // from it, in these steps
  std::array<std::int32_t, motor_count> position_{};  // the hardware's counters

  double now_ = 0;
  double queue_end_ = 0;
  std::deque<double> begins_;  // of the segments that are queued and, first, under way
  bool ends_motion_ = true;  // the last segment
  double stop_time_ = never;
  std::uint32_t stop_cause_{};
  Line line_;

  std::array<AxisPlan, motor_count> axes_{};
  std::deque<Layer> layers_;
  std::int64_t layer_height_{};  // in 10 nm
  double moving_clocks_ = 0;
  double first_step_ = -1;
  std::array<double, 2> filament_mm_{};
  std::uint64_t lines_ = 0;
  std::uint64_t underruns_ = 0;
};

}  // namespace planning
