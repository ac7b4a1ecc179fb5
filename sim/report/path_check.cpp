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
// Z and E are looked at about the middle of lines of so many steps at least, in XY and of their
// own. By then a fraction of the way between these must be done.
constexpr std::int64_t least_steps = 40;
constexpr double middle_from = 0.45, middle_to = 0.55;
// Farther from its end than this, an arc has been begun.
constexpr std::int64_t away_steps = 2;
constexpr double least_part = 0.25, most_part = 0.75;

double square(double value) { return value * value; }

}  // namespace

void PathCheck::set_grid(const MotorGrid& grid) {
  grid_ = grid;
  for (std::size_t i = 0; i < steps_per_mm_.size(); ++i) steps_per_mm_[i] = grid.steps_per_mm(i);
  place_ = grid_.place_mm(position_);
}

void PathCheck::ask(const Move& move) {
  Item item;
  item.arc = move.arc;
  for (std::size_t i = 0; i < item.to.size(); ++i) {
    item.from[i] = millimeters(move.from[i]);
    item.to[i] = millimeters(move.to[i]);
  }
  item.mesh = move.mesh;
  item.z = {millimeters(move.from[2]), millimeters(move.to[2])};
  item.start = grid_.steps_at(above(move.mesh, move.from));
  item.target = grid_.steps_at(above(move.mesh, move.to));
  items_.push_back(item);
  pass_reached_lines();
}

void PathCheck::at(const MotorGrid::Steps& position) {
  position_ = position;
  place_ = grid_.place_mm(position_);
  if (items_.empty() || items_.front().homing) return;
  Item& first = items_.front();
  for (std::size_t i = 0; i < steps_per_mm_.size(); ++i) {
    first.left = first.left || std::abs(position[i] - first.target[i]) > away_steps;
  }
  double distance = distance_mm(items_.front());
  const bool left = steps_of(distance) > left_line_steps;
  if (left && items_.size() > 1 && !items_[1].homing && distance_mm(items_[1]) < distance) {
    pass_lost_line();
    distance = distance_mm(items_.front());
  }
  note_deviation(distance);
  if (steps_of(distance) <= left_line_steps) {
    watch_z_and_e(items_.front());
    watch_height(items_.front());
  }
  pass_reached_lines();
}

// In XY, 0 to 1.
double PathCheck::part_of_way(const Item& item) const {
  if (item.arc) return item.arc->part_at({place_mm(item.arc->first), place_mm(item.arc->second)});
  double length_squared = 0, projection = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const double line = item.to[i] - item.from[i];
    length_squared += square(line);
    projection += line * (place_[i] - item.from[i]);
  }
  return length_squared > 0 ? std::clamp(projection / length_squared, 0.0, 1.0) : 0.0;
}

void PathCheck::watch_z_and_e(Item& item) {
  const auto way = [&](std::size_t axis) { return item.target[axis] - item.start[axis]; };
  const double part = part_of_way(item);
  const bool long_enough = std::max(std::abs(way(0)), std::abs(way(1))) >= least_steps;
  if (item.apart || !long_enough || part < middle_from || part > middle_to) return;
  for (const std::size_t axis : {2UZ, 3UZ, 4UZ}) {
    if (axis == 2 && (item.mesh || !grid_.mechanism().has_own_z())) continue;
    const bool turns = item.arc && (axis == item.arc->first || axis == item.arc->second);
    if (turns || std::abs(way(axis)) < least_steps) continue;
    const double done =
        static_cast<double>(position_[axis] - item.start[axis]) / static_cast<double>(way(axis));
    item.apart = item.apart || done < least_part || done > most_part;
  }
  lines_apart_ += item.apart ? 1 : 0;
}

// Chords leave the path above the mesh by up to 5 um (firmware/motion), and steps a chord by less
// than two of Z's. Where Z itself goes up or down, a place in XY that is a step off counts too.
void PathCheck::watch_height(const Item& item) {
  const bool on_the_way = (position_[0] != item.start[0] || position_[1] != item.start[1]) &&
                          (position_[0] != item.target[0] || position_[1] != item.target[1]);
  if (!item.mesh || !on_the_way) return;
  constexpr double most_chord_deviation_mm = 0.005, most_steps = 2;
  const double length = item.arc ? item.arc->length_mm()
                                 : std::hypot(item.to[0] - item.from[0], item.to[1] - item.from[1]);
  const double way = item.z[1] - item.z[0];
  const double z = item.z[0] + part_of_way(item) * way;
  const double wanted = z + item.mesh->correction(place_[0], place_[1], z);
  const double step = grid_.mechanism().has_own_z() ? 1 / steps_per_mm_[2] : grid_.step_mm(place_);
  const double tolerance = most_chord_deviation_mm +
                           most_steps * (step + grid_.step_mm(place_) * std::abs(way) / length);
  const double error = std::abs(place_[2] - wanted);
  if (error > tolerance) max_height_error_mm_ = std::max(max_height_error_mm_, error);
}

double PathCheck::steps_of(double distance_mm) const {
  const double steps_mm = distance_mm - grid_.mechanism().chord_deviation_mm() - play_mm_;
  return steps_mm > 0 ? steps_mm / grid_.step_mm(place_) : 0;
}

void PathCheck::note_deviation(double distance_mm) {
  max_deviation_mm_ = std::max(max_deviation_mm_, distance_mm);
  max_deviation_steps_ = std::max(max_deviation_steps_, steps_of(distance_mm));
}

// Of an arc in another plane only its range on X or Y counts, at the place on the other of them.
double PathCheck::distance_from_arc_mm(const ArcShape& arc) const {
  const std::array<double, 2> place{place_mm(arc.first), place_mm(arc.second)};
  if (arc.first == 0 && arc.second == 1) return arc.distance(place);
  const std::size_t side = arc.first == 2 ? 1 : 0;
  double low = std::min(arc.at(0)[side], arc.at(1)[side]);
  double high = std::max(arc.at(0)[side], arc.at(1)[side]);
  for (const double part : arc.turning_points()) {
    low = std::min(low, arc.at(part)[side]);
    high = std::max(high, arc.at(part)[side]);
  }
  return std::max({0.0, low - place[side], place[side] - high});
}

double PathCheck::distance_mm(const Item& item) const {
  if (item.arc) return distance_from_arc_mm(*item.arc);
  std::array<double, 2> line{}, point{};
  for (std::size_t i = 0; i < 2; ++i) {
    line[i] = item.to[i] - item.from[i];
    point[i] = place_[i] - item.from[i];
  }
  const double part = part_of_way(item);
  return std::hypot(point[0] - part * line[0], point[1] - part * line[1]);
}

void PathCheck::pass_reached_lines() {
  while (!items_.empty() && reached(items_.front())) items_.pop_front();
}

bool PathCheck::reached(const Item& item) const {
  if (item.homing || item.target[0] != position_[0] || item.target[1] != position_[1]) return false;
  if (!grid_.mechanism().has_own_z() && item.target[2] != position_[2]) return false;
  if (!item.arc) return true;
  const double steps = item.arc->start_radius *
                       std::min(steps_per_mm_[item.arc->first], steps_per_mm_[item.arc->second]);
  return item.target[2] == position_[2] && (item.left || steps < 2 * away_steps);
}

// The next line is nearer than the present one: it was left without arriving at its end
// to the step.
void PathCheck::pass_lost_line() {
  const Item& item = items_.front();
  const bool near = std::abs(position_[0] - item.target[0]) <= near_end_steps &&
                    std::abs(position_[1] - item.target[1]) <= near_end_steps;
  if (near) items_.pop_front();
}

void PathCheck::finish() {
  pass_reached_lines();
  if (!items_.empty() && !items_.back().homing) {
    Item end = items_.back();
    end.arc.reset();
    end.from = end.to;
    const double distance = distance_mm(end);
    note_deviation(distance);
  }
  items_.clear();
}

}  // namespace report
