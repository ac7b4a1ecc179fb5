// SPDX-License-Identifier: Apache-2.0
// Sampling of the even movement between edges, and differences of the samples.
#include "sim/report/axis_courses.hpp"

#include <algorithm>

namespace report {

AxisCourses::AxisCourses(sim::ClockRate rate, std::array<double, axes> steps_per_mm,
                         std::array<std::int64_t, axes> positions)
    : rate_(rate), sample_clocks_(std::max<sim::Clock>(1, rate.clocks(sample_seconds))) {
  const RangeCourse empty(rate.seconds(sample_clocks_));
  for (std::size_t i = 0; i < axes; ++i) {
    tracks_[i].steps_per_mm = steps_per_mm[i];
    tracks_[i].steps = static_cast<double>(positions[i]);
    tracks_[i].window_mm.fill(tracks_[i].steps / steps_per_mm[i]);
    tracks_[i].course = {empty, empty, empty};
  }
}

void AxisCourses::stepped(const devices::StepEdge& edge) {
  if (edge.axis >= axes) return;
  constexpr double half_step = 0.5;
  extend(tracks_[edge.axis], edge.clock,
         static_cast<double>(edge.position) - half_step * edge.direction);
}

// The axis moves evenly from where it was to `steps` at `clock`.
void AxisCourses::extend(Track& track, sim::Clock clock, double steps) const {
  const auto duration = static_cast<double>(clock - track.clock);
  for (sim::Clock at = track.samples * sample_clocks_; at < clock;
       at = track.samples * sample_clocks_) {
    const double part = static_cast<double>(at - track.clock) / duration;
    put_sample(track, track.steps + part * (steps - track.steps));
  }
  track.clock = clock;
  track.steps = steps;
}

void AxisCourses::put_sample(Track& track, double steps) const {
  const double position_mm = steps / track.steps_per_mm;
  track.window_mm[track.samples % window_samples] = position_mm;
  ++track.samples;
  track.course.position_mm.put(position_mm);
  if (track.samples <= half_window_samples) {
    return;  // the middle of the window is not yet in the print
  }
  // Before the beginning the axis stood where it is.
  const double before = track.window_mm[track.samples % window_samples];
  const double middle = track.window_mm[(track.samples + half_window_samples) % window_samples];
  const double h = half_window_samples * rate_.seconds(sample_clocks_);
  track.course.speed_mm_s.put((position_mm - before) / (2 * h));
  track.course.acceleration_mm_s2.put((position_mm - 2 * middle + before) / (h * h));
}

std::array<AxisCourse, AxisCourses::axes> AxisCourses::courses(sim::Clock now) const {
  std::array<AxisCourse, axes> result;
  for (std::size_t i = 0; i < axes; ++i) {
    Track track = tracks_[i];
    extend(track, now + half_window_samples * sample_clocks_ + 1, track.steps);
    result[i] = track.course;
  }
  return result;
}

}  // namespace report
