// SPDX-License-Identifier: Apache-2.0
// Corner speeds by the jump of each axis, then trapezoids.
#include "shaped_plan.hpp"

#include <algorithm>
#include <cmath>

namespace tests {

namespace {

double mm_per_mm(const Way& way, std::size_t axis, const PlanLimits& limits) {
  return (way.to[axis] - way.from[axis]) / limits.steps_per_mm[axis] / way.length_mm;
}

double speed_of(const Way& way, const PlanLimits& limits) {
  double speed = way.speed_mm_s;
  for (std::size_t i = 0; i < 4; ++i) {
    const double share = std::abs(mm_per_mm(way, i, limits));
    if (share * speed > limits.most_mm_s[i]) speed = limits.most_mm_s[i] / share;
  }
  return speed;
}

}  // namespace

double Plan::corner_speed(const Way& before, const Way& after, const PlanLimits& limits) const {
  if (before.pause_s >= 0) return 0;
  double speed = std::min(speed_of(before, limits), speed_of(after, limits));
  for (std::size_t i = 0; i < 4; ++i) {
    const double jump =
        std::abs(mm_per_mm(before, i, limits) - mm_per_mm(after, i, limits)) * speed;
    if (jump > limits.jerk_mm_s[i]) speed *= limits.jerk_mm_s[i] / jump;
  }
  return speed;
}

Plan::Plan(std::vector<Way> ways, const PlanLimits& limits) : ways_(std::move(ways)) {
  const std::size_t count = ways_.size();
  const double twice = 2 * limits.acceleration_mm_s2;
  std::vector<double> entry(count + 1);
  for (std::size_t i = 1; i < count; ++i) entry[i] = corner_speed(ways_[i - 1], ways_[i], limits);
  for (std::size_t i = 0; i < count; ++i) {
    entry[i + 1] =
        std::min(entry[i + 1], std::sqrt(entry[i] * entry[i] + twice * ways_[i].length_mm));
  }
  for (std::size_t i = count; i-- > 0;) {
    entry[i] =
        std::min(entry[i], std::sqrt(entry[i + 1] * entry[i + 1] + twice * ways_[i].length_mm));
  }
  double printed = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Way& way = ways_[i];
    starts_.push_back(seconds());
    printed_.push_back(printed);
    if (way.prints) printed += way.to[3] - way.from[3];
    const double v0 = entry[i], v1 = entry[i + 1], a = limits.acceleration_mm_s2;
    const double peak =
        std::max({v0, v1,
                  std::min(speed_of(way, limits),
                           std::sqrt((v0 * v0 + v1 * v1 + twice * way.length_mm) / 2))});
    const double rise = (peak * peak - v0 * v0) / twice, fall = (peak * peak - v1 * v1) / twice;
    double done = 0;
    add_phase(i, done, v0, a, (peak - v0) / a);
    add_phase(i, done, peak, 0, std::max(0.0, way.length_mm - rise - fall) / peak);
    add_phase(i, done, peak, -a, (peak - v1) / a);
    if (way.pause_s > 0) phases_.push_back({seconds(), way.pause_s, i, 1, 0, 0});
  }
}

void Plan::add_phase(std::size_t way, double& done_mm, double from_mm_s, double acceleration,
                     double time) {
  if (time <= 0) return;
  const double length = ways_[way].length_mm;
  phases_.push_back(
      {seconds(), time, way, done_mm / length, from_mm_s / length, acceleration / length});
  done_mm += from_mm_s * time + acceleration * time * time / 2;
}

double Plan::Cursor::at(double time, std::size_t axis) {
  const auto& phases = plan_->phases_;
  while (phase_ + 1 < phases.size() && phases[phase_ + 1].start <= time) ++phase_;
  const Phase& phase = phases[phase_];
  const double t = std::clamp(time - phase.start, 0.0, phase.time);
  const bool over = phase_ + 1 == phases.size() && t == phase.time;
  const double part =
      over ? 1
           : std::clamp(phase.part + phase.speed * t + phase.acceleration * t * t / 2, 0.0, 1.0);
  const Way& way = plan_->ways_[phase.way];
  if (axis < 4) {
    return part == 1 ? way.to[axis] : way.from[axis] + part * (way.to[axis] - way.from[axis]);
  }
  return plan_->printed_[phase.way] + (way.prints ? part * (way.to[3] - way.from[3]) : 0);
}

}  // namespace tests
