// SPDX-License-Identifier: Apache-2.0
// Matching of positions to lines, in order.
#include "sim/report/path_check.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace report {

namespace {

// Where the edges leave a line by more than a step, this near its end, the next line is meant.
constexpr std::int64_t near_end_steps = 8;
constexpr double left_line_steps = 1.2;

double square(double value) { return value * value; }

}  // namespace

void PathCheck::set_grid(const std::array<Resolution, 2>& steps_per_mm,
                         const std::array<std::int64_t, 2>& origin) {
  resolution_ = steps_per_mm;
  origin_ = origin;
  for (std::size_t i = 0; i < steps_per_mm.size(); ++i) {
    steps_per_mm_[i] = static_cast<double>(steps_per_mm[i]) / billionths;
  }
}

void PathCheck::ask(const Move& move) {
  Item item;
  for (std::size_t i = 0; i < item.to.size(); ++i) {
    item.from[i] = millimeters(move.from[i]);
    item.to[i] = millimeters(move.to[i]);
    item.target[i] = origin_[i] + nearest_step(move.to[i], resolution_[i]);
  }
  items_.push_back(item);
  pass_reached_lines();
}

void PathCheck::at(const std::array<std::int64_t, 2>& position) {
  position_ = position;
  if (items_.empty() || items_.front().homing) {
    return;
  }
  double distance = distance_mm(items_.front());
  const double left_mm = left_line_steps / std::min(steps_per_mm_[0], steps_per_mm_[1]);
  if (distance > left_mm && items_.size() > 1 && !items_[1].homing &&
      distance_mm(items_[1]) < distance) {
    pass_lost_line();
    distance = distance_mm(items_.front());
  }
  max_deviation_mm_ = std::max(max_deviation_mm_, distance);
  pass_reached_lines();
}

double PathCheck::distance_mm(const Item& item) const {
  std::array<double, 2> line{}, point{};
  double length_squared = 0, projection = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    line[i] = item.to[i] - item.from[i];
    point[i] = static_cast<double>(position_[i] - origin_[i]) / steps_per_mm_[i] - item.from[i];
    length_squared += square(line[i]);
    projection += line[i] * point[i];
  }
  const double part = length_squared > 0 ? std::clamp(projection / length_squared, 0.0, 1.0) : 0.0;
  return std::hypot(point[0] - part * line[0], point[1] - part * line[1]);
}

void PathCheck::pass_reached_lines() {
  while (!items_.empty() && !items_.front().homing && items_.front().target == position_) {
    items_.pop_front();
  }
}

// The next line is nearer than the present one: it was left without arriving at its end to the
// step.
void PathCheck::pass_lost_line() {
  const Item& item = items_.front();
  const bool near = std::abs(position_[0] - item.target[0]) <= near_end_steps &&
                    std::abs(position_[1] - item.target[1]) <= near_end_steps;
  if (near) {
    items_.pop_front();
  }
}

void PathCheck::finish() {
  pass_reached_lines();
  if (!items_.empty() && !items_.back().homing) {
    Item end = items_.back();
    end.from = end.to;
    max_deviation_mm_ = std::max(max_deviation_mm_, distance_mm(end));
  }
  items_.clear();
}

}  // namespace report
