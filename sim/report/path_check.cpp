// SPDX-License-Identifier: Apache-2.0
// Matching of edges to lines, in order.
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

PathCheck::PathCheck(std::array<double, 2> steps_per_mm, std::array<std::int64_t, 2> origin)
    : steps_per_mm_(steps_per_mm), origin_(origin), position_(origin) {}

PathCheck::Item PathCheck::item_of(const Move& move) const {
  Item item;
  for (std::size_t i = 0; i < 2; ++i) {
    item.from[i] = move.from[i];
    item.to[i] = move.to[i];
    item.target[i] = origin_[i] + std::llround(move.to[i] * steps_per_mm_[i]);
  }
  return item;
}

void PathCheck::command_sent(sim::Clock, std::size_t, std::string_view command) {
  judge_position();
  gcode_before_ = gcode_;
  item_in_flight_ = false;
  length_in_flight_ = 0;
  const Request request = gcode_.read(command);
  if (const Move* move = std::get_if<Move>(&request)) {
    length_in_flight_ = std::hypot(move->to[0] - move->from[0], move->to[1] - move->from[1],
                                   move->to[2] - move->from[2]);
    items_.push_back(item_of(*move));
    item_in_flight_ = true;
    pass_reached_points();
  } else if (const Homing* homing = std::get_if<Homing>(&request)) {
    items_.push_back({.homing = true, .homed_axes = {homing->axes[0], homing->axes[1]}});
    item_in_flight_ = true;
  }
}

void PathCheck::command_acknowledged(sim::Clock, std::size_t, std::string_view command,
                                     bool executed) {
  if (!executed) {
    gcode_ = gcode_before_;
    if (item_in_flight_ && !items_.empty()) {
      items_.pop_back();
    }
  } else {
    length_mm_ += length_in_flight_;
    const bool waits_for_motion = command.starts_with("M400");
    if (waits_for_motion || (item_in_flight_ && !items_.empty() && items_.back().homing)) {
      finish_all();
    }
  }
  item_in_flight_ = false;
}

void PathCheck::stepped(const devices::StepEdge& edge) {
  if (edge.axis >= 2) {
    return;
  }
  if (edge.clock != last_edge_) {
    judge_position();
  }
  last_edge_ = edge.clock;
  position_[edge.axis] = edge.position;
  judged_ = false;
}

void PathCheck::judge_position() {
  if (judged_) {
    return;
  }
  judged_ = true;
  if (items_.empty() || items_.front().homing) {
    return;
  }
  double distance = distance_mm(items_.front());
  const double left_mm = left_line_steps / std::min(steps_per_mm_[0], steps_per_mm_[1]);
  if (distance > left_mm && items_.size() > 1 && !items_[1].homing &&
      distance_mm(items_[1]) < distance) {
    pass_lost_point();
    distance = distance_mm(items_.front());
  }
  max_deviation_mm_ = std::max(max_deviation_mm_, distance);
  pass_reached_points();
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

void PathCheck::pass_reached_points() {
  while (!items_.empty() && !items_.front().homing && items_.front().target == position_) {
    // A line without X or Y steps is no point of its own.
    ++points_reached_;
    items_.pop_front();
  }
}

// The next line is nearer than the present one: it was left without arriving at its end to the
// step.
void PathCheck::pass_lost_point() {
  const Item& item = items_.front();
  const bool near = std::abs(position_[0] - item.target[0]) <= near_end_steps &&
                    std::abs(position_[1] - item.target[1]) <= near_end_steps;
  if (near) {
    ++points_missed_;
    items_.pop_front();
  }
}

// Everything asked for has been made: what has not been reached by now has been missed.
void PathCheck::finish_all() {
  judge_position();
  pass_reached_points();
  while (!items_.empty()) {
    const Item item = items_.front();
    items_.pop_front();
    if (item.homing) {
      finish_homing(item);
    } else {
      ++points_missed_;
      if (items_.empty()) {
        Item end = item;
        end.from = item.to;
        max_deviation_mm_ = std::max(max_deviation_mm_, distance_mm(end));
      }
    }
  }
}

void PathCheck::finish_homing(const Item& homing) {
  for (std::size_t i = 0; i < 2; ++i) {
    if (homing.homed_axes[i]) {
      origin_[i] = 0;
    }
  }
  homed_ = true;
}

}  // namespace report
