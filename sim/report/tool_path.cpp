// SPDX-License-Identifier: Apache-2.0
// Collecting points from step edges, and thinning them.
#include "sim/report/tool_path.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace report {

namespace {

constexpr double kept_distance_mm = 0.1;

double distance_from_line(const ToolPoint& point, const ToolPoint& from, const ToolPoint& to) {
  const double dx = to.x - from.x, dy = to.y - from.y, dz = to.z - from.z;
  const double px = point.x - from.x, py = point.y - from.y, pz = point.z - from.z;
  const double squared = dx * dx + dy * dy + dz * dz;
  const double part =
      squared > 0 ? std::clamp((px * dx + py * dy + pz * dz) / squared, 0.0, 1.0) : 0.0;
  return std::hypot(px - part * dx, py - part * dy, pz - part * dz);
}

}  // namespace

ToolPath::ToolPath(std::array<double, 4> steps_per_mm, std::array<std::int64_t, 4> positions)
    : steps_per_mm_(steps_per_mm), positions_(positions), kept_(positions) {
  begin_here();
}

void ToolPath::begin_here() {
  points_.clear();
  kept_ = positions_;
  points_.push_back(present());
  points_.back().extruding = false;
}

ToolPoint ToolPath::present() const {
  return {static_cast<float>(static_cast<double>(positions_[0]) / steps_per_mm_[0]),
          static_cast<float>(static_cast<double>(positions_[1]) / steps_per_mm_[1]),
          static_cast<float>(static_cast<double>(positions_[2]) / steps_per_mm_[2]),
          positions_[3] > kept_[3]};
}

void ToolPath::keep() {
  points_.push_back(present());
  kept_ = positions_;
}

void ToolPath::stepped(const devices::StepEdge& edge) {
  if (edge.axis >= positions_.size()) {
    return;
  }
  positions_[edge.axis] = edge.position;
  if (edge.axis == 3) {
    // Filament that moves while the nozzle stands belongs to no line.
    if (kept_[0] == positions_[0] && kept_[1] == positions_[1]) {
      kept_[3] = positions_[3];
    }
    return;
  }
  double squared = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double way = static_cast<double>(positions_[i] - kept_[i]) / steps_per_mm_[i];
    squared += way * way;
  }
  if (squared >= kept_distance_mm * kept_distance_mm) {
    keep();
  }
}

std::vector<ToolPoint> ToolPath::points() const {
  std::vector<ToolPoint> all = points_;
  all.push_back(present());
  return all;
}

std::vector<ToolPoint> simplified(const std::vector<ToolPoint>& points, double tolerance_mm) {
  if (points.size() < 3) {
    return points;
  }
  std::vector<bool> kept(points.size(), false);
  kept.front() = kept.back() = true;
  // A change between travel and extrusion ends a line whatever its shape.
  std::vector<std::size_t> ends{0};
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    if (points[i].extruding != points[i + 1].extruding) {
      kept[i] = true;
      ends.push_back(i);
    }
  }
  ends.push_back(points.size() - 1);
  std::vector<std::pair<std::size_t, std::size_t>> stretches;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    stretches.emplace_back(ends[i - 1], ends[i]);
  }
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
    if (kept[i]) {
      result.push_back(points[i]);
    }
  }
  return result;
}

}  // namespace report
