// SPDX-License-Identifier: Apache-2.0
// Collecting points from step edges, and thinning them.
#include "sim/report/tool_path.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace report {

namespace {

// The steps of the extruder along a line are this near to each other, or the way between is travel.
constexpr double longest_way_between_extruder_steps_mm = 1.0;
constexpr double shortest_rest_seconds = 0.05;
// So many points are thinned at a time.
constexpr std::size_t most_latest = 8192;

double distance_from_line(const ToolPoint& point, const ToolPoint& from, const ToolPoint& to) {
  const double dx = to.x - from.x, dy = to.y - from.y, dz = to.z - from.z;
  const double px = point.x - from.x, py = point.y - from.y, pz = point.z - from.z;
  const double squared = dx * dx + dy * dy + dz * dz;
  const double part =
      squared > 0 ? std::clamp((px * dx + py * dy + pz * dz) / squared, 0.0, 1.0) : 0.0;
  return std::hypot(px - part * dx, py - part * dy, pz - part * dz);
}

bool rests(const ToolPoint& from, const ToolPoint& to) {
  return from.x == to.x && from.y == to.y && from.z == to.z;
}

double distance(const ToolPoint& from, const ToolPoint& to) {
  return std::hypot(to.x - from.x, to.y - from.y, to.z - from.z);
}

}  // namespace

ToolPath::ToolPath(sim::ClockRate rate, std::array<double, 4> steps_per_mm,
                   std::array<std::int64_t, 4> positions,
                   std::shared_ptr<const machine::Mechanism> mechanism)
    : rate_(rate),
      steps_per_mm_(steps_per_mm),
      positions_(positions),
      mechanism_(std::move(mechanism)),
      origin_mm_(place_mm()),
      tolerance_mm_(tolerance_steps / std::max(steps_per_mm[0], steps_per_mm[1])) {
  begin_here();
}

bool ToolPath::homed(std::array<bool, 3> axes) {
  bool any = false;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (axes[i] && !homed_[i]) {
      homed_[i] = any = true;
      origin_mm_[i] = 0;
    }
  }
  if (any) begin_here();
  return any;
}

void ToolPath::begin_here() {
  points_.clear();
  latest_.assign(1, present());
  extruded_at_ = 0;
  way_since_extruded_mm_ = std::numeric_limits<double>::infinity();
  moved_ = false;
}

std::array<double, 3> ToolPath::place_mm() const {
  std::array<double, 3> motors{};
  for (std::size_t i = 0; i < motors.size(); ++i) {
    motors[i] = static_cast<double>(positions_[i]) / steps_per_mm_[i];
  }
  return mechanism_->place_of(motors);
}

ToolPoint ToolPath::present() const {
  const std::array<double, 3> place = place_mm();
  const auto mm = [&](std::size_t axis) {
    return static_cast<float>(place[axis] - origin_mm_[axis]);
  };
  return {mm(0), mm(1), mm(2), false, rate_.seconds(clock_)};
}

void ToolPath::keep_present() {
  if (!moved_) return;
  moved_ = false;
  const ToolPoint point = present();
  way_since_extruded_mm_ += distance(latest_.back(), point);
  latest_.push_back(point);
  if (latest_.size() >= most_latest) thin();
}

void ToolPath::stepped(const devices::StepEdge& edge) {
  if (edge.axis >= positions_.size()) {
    extruder_stepped(edge.direction);  // the second one
    return;
  }
  if (edge.axis == 3) {
    positions_[3] = edge.position;
    extruder_stepped(edge.direction);
    return;
  }
  if (edge.clock != clock_) {
    keep_present();
    if (rate_.seconds(edge.clock - clock_) > shortest_rest_seconds) {
      clock_ = edge.clock;
      latest_.push_back(present());  // the nozzle has stood until now
    }
  }
  clock_ = edge.clock;
  positions_[edge.axis] = edge.position;
  moved_ = true;
}

// The way since the step before was extruded too, if it is short.
void ToolPath::extruder_stepped(int direction) {
  keep_present();
  if (direction < 0) {
    way_since_extruded_mm_ = std::numeric_limits<double>::infinity();
    return;
  }
  if (way_since_extruded_mm_ <= longest_way_between_extruder_steps_mm) {
    for (std::size_t i = extruded_at_ + 1; i < latest_.size(); ++i) {
      latest_[i].extruding = !rests(latest_[i - 1], latest_[i]);
    }
  }
  extruded_at_ = latest_.size() - 1;
  way_since_extruded_mm_ = 0;
}

// Up to the latest step of the extruder, if the next one may still change what is after it.
void ToolPath::thin() {
  const bool open = way_since_extruded_mm_ <= longest_way_between_extruder_steps_mm;
  const std::size_t end =
      open && extruded_at_ > most_latest / 2 ? extruded_at_ : latest_.size() - 1;
  const auto last = latest_.begin() + static_cast<std::ptrdiff_t>(end);
  const std::vector<ToolPoint> thinned = simplified({latest_.begin(), last + 1}, tolerance_mm_);
  points_.insert(points_.end(), thinned.begin(), thinned.end() - 1);
  latest_.erase(latest_.begin(), last);
  extruded_at_ -= std::min(extruded_at_, end);
}

std::vector<ToolPoint> ToolPath::points() const {
  std::vector<ToolPoint> all = latest_;
  if (moved_) all.push_back(present());
  all = simplified(all, tolerance_mm_);
  all.insert(all.begin(), points_.begin(), points_.end());
  return all;
}

std::vector<ToolPoint> simplified(const std::vector<ToolPoint>& points, double tolerance_mm) {
  if (points.size() < 3) return points;
  std::vector<bool> kept(points.size(), false);
  kept.front() = kept.back() = true;
  // A change between travel and extrusion, or a rest, ends a line whatever its shape.
  std::vector<std::size_t> ends{0};
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    if (points[i].extruding != points[i + 1].extruding || rests(points[i - 1], points[i]) ||
        rests(points[i], points[i + 1])) {
      kept[i] = true;
      ends.push_back(i);
    }
  }
  ends.push_back(points.size() - 1);
  std::vector<std::pair<std::size_t, std::size_t>> stretches;
  for (std::size_t i = 1; i < ends.size(); ++i) stretches.emplace_back(ends[i - 1], ends[i]);
  while (!stretches.empty()) {
    const auto [first, last] = stretches.back();
    stretches.pop_back();
    double farthest = tolerance_mm;
    std::size_t split = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double distance = distance_from_line(points[i], points[first], points[last]);
      if (distance > farthest) {
        farthest = distance;
        split = i;
      }
    }
    if (split != first) {
      kept[split] = true;
      stretches.emplace_back(first, split);
      stretches.emplace_back(split, last);
    }
  }
  std::vector<ToolPoint> result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (kept[i]) result.push_back(points[i]);
  }
  return result;
}

}  // namespace report
