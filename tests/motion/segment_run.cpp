// SPDX-License-Identifier: Apache-2.0
// Speeds and accelerations of the axes from the numbers in the segments.
#include "tests/motion/segment_run.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tests/motion/machine.hpp"

namespace motion_test {

namespace {

struct Course {
  double begin, end, acceleration;  // ticks/s, ticks/s^2, the highest of it
  double seconds;
};

// With a jerk; its time is halved in until its ticks are made.
Course course_of_third_order(const motion::Segment& segment, double clock) {
  const double jerk = std::ldexp(static_cast<double>(segment.jerk), -84) * clock * clock * clock;
  const double acceleration =
      std::ldexp(static_cast<double>(segment.acceleration - segment.jerk), -84) * clock * clock;
  const double rate = std::ldexp(static_cast<double>(segment.rate), -64) * clock -
                      acceleration / clock / 2 - jerk / clock / clock / 6;
  const auto ticks = [&](double t) { return ((jerk / 6 * t + acceleration / 2) * t + rate) * t; };
  double low = 0, high = 1e-6;
  // Not far beyond it: there the rate falls below 0.
  while (ticks(high) < segment.ticks && high < 1e9) low = high, high *= 1.2;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (ticks(middle) < segment.ticks ? low : high) = middle;
  }
  return {rate, (jerk / 2 * high + acceleration) * high + rate,
          std::max(std::abs(acceleration), std::abs(acceleration + jerk * high)), high};
}

Course course_of(const motion::Segment& segment, double clock) {
  if (segment.jerk != 0) return course_of_third_order(segment, clock);
  const double rate = std::ldexp(static_cast<double>(segment.rate), -64) * clock;
  const double acceleration =
      std::ldexp(static_cast<double>(segment.acceleration), -84) * clock * clock;
  const double end = std::sqrt(std::max(rate * rate + 2 * acceleration * segment.ticks, 0.0));
  return {rate, end, acceleration, 2 * segment.ticks / (rate + end)};
}

class Watch {
 public:
  Watch(const motion::Limits& limits, double clock, SegmentRunResult& result)
      : limits_(limits), clock_(clock), result_(result) {}

  double see(const motion::Segment& segment) {
    const Course course = course_of(segment, clock_);
    result_.seconds += course.seconds;
    for (std::size_t i = 0; i < units::axis_count; ++i) see_axis(i, segment, course);
    if (!segment.continues_line) {
      result_.speeds.push_back(course.begin);
      result_.lines.push_back(segment);
      for (std::size_t i = 0; i < units::axis_count; ++i) {
        see_jump(i, segment, course);
        result_.steps[i] += segment.steps[i];
      }
    }
    if (segment.jerk != 0) ++result_.third_order;
    before_ = segment;
    before_course_ = course;
    return course.seconds;
  }

 private:
  double share(std::size_t axis, const motion::Segment& segment) const {
    const double step_mm = 1e3 / limits_.axes[axis].steps_per_meter.count();
    return segment.steps[axis] * step_mm / segment.line_ticks;
  }

  // A line of n steps may have one that its distance has not.
  void see_axis(std::size_t axis, const motion::Segment& segment, const Course& course) {
    const double steps = std::abs(segment.steps[axis]);
    if (steps < 2) return;
    const motion::AxisLimits& limits = limits_.axes[axis];
    const double room = steps / (steps - 1);
    const double part = std::abs(share(axis, segment));
    const double speed = std::max(course.begin, course.end) * part;
    const double acceleration = std::abs(course.acceleration) * part;
    result_.worst_speed =
        std::max(result_.worst_speed, speed / (limits.max_speed.count() * 1e-3) - 1);
    result_.worst_acceleration =
        std::max(result_.worst_acceleration,
                 acceleration / (limits.max_acceleration.count() * 1e-3 * room) - 1);
  }

  void see_jump(std::size_t axis, const motion::Segment& segment, const Course& course) {
    const double step_mm = 1e3 / limits_.axes[axis].steps_per_meter.count();
    double allowed = limits_.axes[axis].jerk.count() * 1e-3;
    const auto allow = [&](const motion::Segment& side, const Course& at, double rate) {
      allowed += rate / side.line_ticks * step_mm;
      allowed += 1.02 * std::abs(share(axis, side)) * std::sqrt(std::abs(at.acceleration));
    };
    allow(segment, course, course.begin);
    double before = 0;
    if (before_ && !before_->ends_motion) {
      allow(*before_, before_course_, before_course_.end);
      before = share(axis, *before_) * before_course_.end;
    }
    const double jump = std::abs(share(axis, segment) * course.begin - before);
    result_.worst_jump = std::max(result_.worst_jump, jump / allowed - 1);
  }

  const motion::Limits& limits_;
  double clock_;
  SegmentRunResult& result_;
  std::optional<motion::Segment> before_;
  Course before_course_{};
};

}  // namespace

double seconds_of(const motion::Segment& segment, double clock_hz) {
  return course_of(segment, clock_hz).seconds;
}

SegmentRunResult run_segments(const motion::Limits& limits,
                              const std::vector<motion::LineMove>& moves, std::uint32_t clock_hz,
                              std::size_t look_ahead) {
  motion::Planner planner(limits, timing(clock_hz));
  SegmentRunResult result;
  Watch watch(limits, clock_hz, result);
  double now_us = 0, end_us = 0;
  const auto now = [&] { return units::Microseconds(static_cast<std::int64_t>(now_us)); };
  for (std::size_t fed = 0; fed < moves.size() || !planner.empty();) {
    while (fed < moves.size() && planner.has_room() && planner.lines() < look_ahead) {
      // As if all came at once: a host that is slow slows down motion.
      if (!planner.append(moves[fed++], {})) throw std::logic_error("a move is refused");
    }
    if (fed == moves.size() || planner.lines() == look_ahead) planner.flush();
    if (const auto segment = planner.next_segment(now())) {
      end_us = std::max(end_us, now_us) + 1e6 * watch.see(*segment);
    } else {
      now_us = std::max(now_us + 500, end_us - 30'000);
    }
  }
  return result;
}

}  // namespace motion_test
