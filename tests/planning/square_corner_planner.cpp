// SPDX-License-Identifier: Apache-2.0
// Moves of a file, the speeds at their ends, and the time of their trapezoids.
#include "tests/planning/square_corner_planner.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <string>

namespace planning {

namespace {

constexpr double unlimited = 1e18;

std::map<char, double> words_of(std::string_view line) {
  std::map<char, double> words;
  const std::string text(line.substr(0, line.find(';')));
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] < 'A' || text[i] > 'Z') continue;
    words[text[i]] = std::strtod(text.c_str() + i + 1, nullptr);
  }
  return words;
}

}  // namespace

void SquareCornerPlanner::take(std::string_view line) {
  const auto words = words_of(line);
  if (words.contains('M')) {
    const int code = static_cast<int>(words.at('M'));
    if (code == 82 || code == 83) relative_e_ = code == 83;
    return;
  }
  if (!words.contains('G')) return;
  const int code = static_cast<int>(words.at('G'));
  if (code == 90 || code == 91) relative_ = code == 91;
  if (code != 0 && code != 1 && code != 92) return;
  if (code != 92 && words.contains('F')) speed_ = words.at('F') / 60;
  Vector target = position_;
  for (std::size_t i = 0; i < target.size(); ++i) {
    const auto word = words.find("XYZE"[i]);
    if (word == words.end()) continue;
    const bool adds = code != 92 && (relative_ || (i == 3 && relative_e_));
    target[i] = adds ? position_[i] + word->second : word->second;
  }
  if (code != 92) append(target);
  position_ = target;
}

void SquareCornerPlanner::append(const Vector& target) {
  Vector way{};
  for (std::size_t i = 0; i < way.size(); ++i) way[i] = target[i] - position_[i];
  Move move;
  const double spatial = std::hypot(way[0], way[1], way[2]);
  move.travels = spatial > 1e-9;
  move.length = move.travels ? spatial : std::abs(way[3]);
  if (move.length < 1e-9) return;
  for (std::size_t i = 0; i < way.size(); ++i) move.direction[i] = way[i] / move.length;
  double speed = speed_;
  if (move.travels) {
    move.acceleration = limits_.acceleration;
    speed = std::min(speed, limits_.speed);
    if (const double rise = std::abs(move.direction[2]); rise > 0) {
      speed = std::min(speed, limits_.z_speed / rise);
      move.acceleration = std::min(move.acceleration, limits_.z_acceleration / rise);
    }
  } else {
    move.acceleration = limits_.filament_acceleration;
    speed = std::min(speed, limits_.filament_speed);
  }
  move.highest = speed * speed;
  if (!moves_.empty()) move.highest_start = corner_square(moves_.back(), move);
  moves_.push_back(move);
}

// The square of the speed in the corner. An extruder that works alone begins and ends at rest.
double SquareCornerPlanner::corner_square(const Move& before, const Move& after) const {
  if (!before.travels || !after.travels) return 0;
  double square = std::min(before.highest, after.highest);
  if (const double change = std::abs(after.direction[3] - before.direction[3]); change > 0) {
    square = std::min(square, std::pow(limits_.filament_corner_speed / change, 2));
  }
  double along = 0;
  for (std::size_t i = 0; i < 3; ++i) along += before.direction[i] * after.direction[i];
  // Half the angle between the lines, which is a straight one where they go on straight.
  const double sine = std::sqrt(std::max(0.5 * (1 + along), 0.0));
  const double cosine = std::sqrt(std::max(0.5 * (1 - along), 0.0));
  if (cosine < 1e-9) return square;
  const double tangent = sine / cosine;
  const double deviation = std::pow(limits_.square_corner_speed, 2) * (std::sqrt(2.0) - 1);
  square = std::min(square, sine < 1 ? deviation / limits_.acceleration * sine / (1 - sine) *
                                           std::min(before.acceleration, after.acceleration)
                                     : unlimited);
  // The circle that touches both lines in their middle at the latest.
  for (const Move* move : {&before, &after}) {
    square = std::min(square, 0.5 * move->length * tangent * move->acceleration);
  }
  return square;
}

double SquareCornerPlanner::seconds() {
  double end = 0;
  for (auto move = moves_.rbegin(); move != moves_.rend(); ++move) {
    move->start = std::min(move->highest_start, end + 2 * move->acceleration * move->length);
    end = move->start;
  }
  double time = 0, start = 0;
  for (std::size_t i = 0; i < moves_.size(); ++i) {
    const Move& move = moves_[i];
    const double gain = 2 * move.acceleration * move.length;
    const double next = i + 1 < moves_.size() ? std::min(moves_[i + 1].start, start + gain) : 0;
    const double peak = std::min(move.highest, (start + next + gain) / 2);
    const double top = std::sqrt(peak);
    const double cruised = move.length - (2 * peak - start - next) / (2 * move.acceleration);
    time += (2 * top - std::sqrt(start) - std::sqrt(next)) / move.acceleration + cruised / top;
    start = next;
  }
  return time;
}

}  // namespace planning
