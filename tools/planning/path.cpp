// SPDX-License-Identifier: Apache-2.0
// Points, layers, and which command a line belongs to.
#include "tools/planning/path.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace planning {

namespace {

constexpr std::size_t most_left_out = 32;
constexpr double same_height_mm = 1e-3;

double distance_to_line(const PathPoint& point, const PathPoint& from, const PathPoint& to) {
  const double x = to.x_mm - from.x_mm, y = to.y_mm - from.y_mm;
  const double px = point.x_mm - from.x_mm, py = point.y_mm - from.y_mm;
  const double length = x * x + y * y;
  const double along = length > 0 ? std::clamp((px * x + py * y) / length, 0.0, 1.0) : 0;
  return std::hypot(px - along * x, py - along * y);
}

}  // namespace

void PathRecorder::end_command(std::uint64_t lines) {
  if (lines > lines_) taken_.push_back({.lines = lines, .command = command_});
}

// The first command after which this line was planned; the one in hand where that is not known yet.
std::uint32_t PathRecorder::command_of(std::uint64_t line) {
  while (!taken_.empty() && taken_.front().lines < line) taken_.pop_front();
  return taken_.empty() ? command_ : taken_.front().command;
}

void PathRecorder::add(const Walk& walk) {
  const std::uint32_t command = command_of(++lines_);
  const auto from = std::exchange(position_, walk.end_mm);
  const bool moves = from[0] != position_[0] || from[1] != position_[1];
  const bool extrudes = moves && walk.filament_mm > 0;
  const double rise = position_[2] - layer_z_;
  const bool is_flat = std::abs(position_[2] - from[2]) < same_height_mm;
  const bool is_other = is_flat ? std::abs(rise) >= same_height_mm : rise >= rise_mm;
  const PathPoint begin{.x_mm = static_cast<float>(from[0]),
                        .y_mm = static_cast<float>(from[1]),
                        .command = command,
                        .extrudes = false};
  if (path_.points.empty()) {
    path_.layers.push_back({.z_mm = position_[2], .first = 0});
    append(begin);
  }
  if (!moves) return;
  if (extrudes && (!has_layer_ || is_other)) {
    if (has_layer_) {
      path_.layers.push_back({.z_mm = position_[2], .first = path_.points.size()});
      left_out_.clear();
      path_.points.push_back(begin);
    }
    path_.layers.back().z_mm = layer_z_ = position_[2];
    has_layer_ = true;
  }
  append({.x_mm = static_cast<float>(position_[0]),
          .y_mm = static_cast<float>(position_[1]),
          .command = command,
          .extrudes = extrudes});
}

// The last point, and those left out before it, lie on the way from the one before to this one.
bool PathRecorder::is_straight_to(const PathPoint& point) const {
  const auto& points = path_.points;
  if (points.size() < path_.layers.back().first + 2 || left_out_.size() >= most_left_out) {
    return false;
  }
  const PathPoint &last = points.back(), &before = points[points.size() - 2];
  if (last.extrudes != point.extrudes) return false;
  const auto is_near = [&](const PathPoint& each) {
    return distance_to_line(each, before, point) <= tolerance_mm;
  };
  return is_near(last) && std::ranges::all_of(left_out_, is_near);
}

void PathRecorder::append(const PathPoint& point) {
  if (is_straight_to(point)) {
    left_out_.push_back(path_.points.back());
    path_.points.back() = point;
    return;
  }
  left_out_.clear();
  path_.points.push_back(point);
}

Path PathRecorder::finish(const std::array<double, 3>& steps_per_mm) {
  path_.steps_per_mm = steps_per_mm;
  return std::move(path_);
}

}  // namespace planning
