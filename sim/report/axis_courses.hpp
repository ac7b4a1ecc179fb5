// SPDX-License-Identifier: Apache-2.0
// Position, speed and acceleration of each axis over time, from its step edges alone.
#pragma once

#include <array>
#include <cstddef>

#include "sim/devices/step_edge.hpp"
#include "sim/report/range_course.hpp"
#include "sim/simulation/clock_rate.hpp"

namespace report {

struct AxisCourse {
  RangeCourse position_mm;
  RangeCourse speed_mm_s;
  RangeCourse acceleration_mm_s2;
};

// An edge marks the instant at which the axis is half-way between two steps; between edges it moves
// evenly. From this x(t), with h = half_window_seconds,
//   speed        (x(t + h) - x(t - h)) / 2h: the mean over 2h,
//   acceleration (x(t + h) - 2 x(t) + x(t - h)) / h^2: the mean over 2h, weighted by a triangle.
// A mean is never higher than the highest of what it is made of, so a value above a limit is real,
// but for two things: Bresenham makes the edges of an axis that is not the fastest late by up to
// one tick, thus x wrong by less than a step peak to peak, which is worth at most
// 2 steps / h^2; and a jump of speed at a corner (jerk) of J is worth J / h.
class AxisCourses : public devices::StepListener {
 public:
  static constexpr std::size_t axes = 4;
  static constexpr double sample_seconds = 0.002;
  static constexpr std::size_t half_window_samples = 5;
  static constexpr double half_window_seconds = half_window_samples * sample_seconds;

  AxisCourses(sim::ClockRate rate, std::array<double, axes> steps_per_mm,
              std::array<std::int64_t, axes> positions);

  void stepped(const devices::StepEdge& edge) override;
  // Up to `now`.
  std::array<AxisCourse, axes> courses(sim::Clock now) const;

 private:
  static constexpr std::size_t window_samples = 2 * half_window_samples + 1;

  struct Track {
    double steps_per_mm{};
    sim::Clock clock = 0;  // of the latest edge
    double steps{};  // where the axis was then
    std::size_t samples = 0;
    std::array<double, window_samples> window_mm{};  // the latest samples, in a ring
    AxisCourse course;
  };

  void extend(Track& track, sim::Clock clock, double steps) const;
  void put_sample(Track& track, double steps) const;

  sim::ClockRate rate_;
  sim::Clock sample_clocks_;
  std::array<Track, axes> tracks_;
};

}  // namespace report
