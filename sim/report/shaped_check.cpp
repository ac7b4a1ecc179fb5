// SPDX-License-Identifier: Apache-2.0
// Lines in pieces, and the spaces around them.
#include "sim/report/shaped_check.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace report {

namespace {

constexpr std::size_t height = 2, extruder = 3;
// Positions are sampled once a slot, and one between samples is made of those about it.
constexpr double slots_about_sample = 3;
// Arcs, and lines on which motors do not go evenly, are in pieces straight to less than a step.
constexpr double longest_piece_mm = 0.5, arc_deviation_mm = 0.001;
// A chip has fewer lines in its buffers. What is older is not made any more.
constexpr std::size_t most_lines = 1024;

double filament_of(const Move& move) {
  double filament = 0;
  for (std::size_t i = extruder; i < motor_count; ++i) {
    filament += std::abs(millimeters(move.to[i] - move.from[i]));
  }
  return filament;
}

// Of the filament where nothing else moves.
double length_of(const Move& move) {
  const double length = move.length_mm();
  return length > 0 ? length : filament_of(move);
}

// At most.
double speed_of(const Move& move, double fastest_mm_s) {
  const double speed = move.speed_mm_s > 0 ? move.speed_mm_s : fastest_mm_s;
  const double filament = filament_of(move);
  if (filament == 0 || move.extruder_mm_s == 0) return speed;
  return std::min(speed, move.extruder_mm_s * length_of(move) / filament);
}

}  // namespace

void ShapedCheck::Range::include(double value) {
  low = std::min(low, value);
  high = std::max(high, value);
}

// Slots are 1 to 2 ms and at least 2^14 clocks long; where 64 of them do not hold a shaper, twice
// that (firmware/motion/shaping.md).
void ShapedCheck::set_shaping(const ShapingSetting& setting) {
  constexpr double slots_per_second = 500, most_slots = 56;
  constexpr unsigned least_bits = 14;
  const auto clocks = static_cast<std::uint64_t>(clock_hz_ / slots_per_second);
  const unsigned bits = std::max(static_cast<unsigned>(std::bit_width(clocks)) - 1, least_bits);
  slot_s_ = std::ldexp(1 / clock_hz_, static_cast<int>(bits));
  double longest = 0;
  deviation_s_ = {};
  extra_turns_ = {};
  for (std::size_t i = 0; i < setting.shapers.size(); ++i) {
    const ShaperTimes times = times_of(setting.shapers[i]);
    deviation_s_[i] = times.deviation_s;
    // A way speeds up, goes on and slows down. The sum has these parts once for each impulse; in
    // each it may turn once, and at a turn rounding may make a step more.
    constexpr double parts_of_way = 3;
    if (times.impulses > 1) extra_turns_[i] = parts_of_way * static_cast<double>(times.impulses);
    longest = std::max(longest, times.length_s);
  }
  advance_s_ = static_cast<double>(setting.advance_us) * 1e-6;
  if (advance_s_ > 0) longest += advance_window_s;
  if (longest > most_slots * slot_s_) slot_s_ *= 2;
  window_s_ = longest + slots_about_sample * slot_s_;
}

// Near its ends a line may be in the shapers together with others, in its middle it is alone.
std::vector<double> ShapedCheck::parts_of(const Move& move, double length, double speed) const {
  double pieces = 1;
  if (move.arc) {
    const double radius = std::max({move.arc->start_radius, move.arc->end_radius, 1e-3});
    pieces = move.arc->length_mm() / std::sqrt(8 * radius * arc_deviation_mm);
  }
  if (move.mesh || !grid_.mechanism().is_cartesian()) {
    pieces = std::max(pieces, length / longest_piece_mm);
  }
  const int count = std::max(1, static_cast<int>(std::ceil(pieces)));
  std::vector<double> parts;
  if (count == 1) {
    const double near_end = speed * window_s_ / length;
    if (length > 0 && 2 * near_end < 1) parts = {near_end, 1 - near_end};
  }
  for (int i = 1; i < count; ++i) parts.push_back(static_cast<double>(i) / count);
  parts.push_back(1);
  return parts;
}

void ShapedCheck::ask(const Move& move, RequestedLine line, const Steps& target,
                      const std::optional<Steps>& other) {
  if (takes_no_motion(move, line, target)) return;
  Motors ways{};
  for (std::size_t i = 0; i < motor_count; ++i) {
    ways[i] = static_cast<double>(std::llabs(target[i] - last_target_[i]));
  }
  if (lines_.size() == most_lines) drop_oldest_line();
  lines_.push_back({{std::move(line)}, target});
  last_target_ = target;
  last_other_ = other;
  std::array<Course, motor_count> courses{};
  for (const Move& way : move.ways()) add_pieces(way, courses);
  pieces_.back().ends_line = true;
  for (std::size_t i = 0; i < motor_count; ++i) {
    // Where it turns, rounding may make a step more on each part of its way.
    if (const int turns = courses[i].turns; turns > 0) {
      ways[i] = std::max(ways[i], courses[i].way) + turns + 1;
    }
    ways[i] += 2 * pieces_.back().loose[i];  // there first, and back from there
    asked_[i] += ways[i];
    // Linear advance goes there and back, and where it turns, rounding may make a step more.
    if (i >= extruder && pieces_.back().advanced > 0) {
      asked_[i] += 2 * advance_s_ * pieces_.back().advanced + 2;
    }
  }
  ended_ = is_at_last_target(now_.position) && may_have_ended();
  if (ended_) end_ = now_;
}

// It is reached together with the line before it.
bool ShapedCheck::takes_no_motion(const Move& move, RequestedLine& line, const Steps& target) {
  const bool moves = move.arc || move.to != move.from || (move.over && move.over != move.from);
  if (target != last_target_ || moves) return false;
  if (ended_ && is_at_last_target(now_.position)) {
    ++reached_;
    return true;
  }
  if (lines_.empty() || lines_.back().texts.size() == most_lines) return false;
  lines_.back().texts.push_back(std::move(line));
  if (lines_.back().missed) missed_.push_back({lines_.back().texts.back(), target, now_});
  return true;
}

void ShapedCheck::drop_oldest_line() {
  const std::size_t line = lines_done_;
  miss(line);
  std::size_t count = first_;
  while (count < pieces_.size() && pieces_[count].line <= line) pieces_[count++].reach.reset();
  pass(count);
  pass_line(line);
  lost_ = lost_ || first_ >= behind_reach_;
  behind_reach_ = std::max(behind_reach_, first_);
}

void ShapedCheck::add_pieces(const Move& move, std::array<Course, motor_count>& courses) {
  const double length = length_of(move);
  const double speed = speed_of(move, fastest_mm_s_);
  const auto place_at = [&](double part) {
    const auto place = move.place_mm(part);
    return std::array{place[0], place[1]};
  };
  Piece piece;
  piece.way = ways_++;
  piece.line = lines_done_ + lines_.size() - 1;
  // Where motors are not axes, each of the three goes along with Z.
  const bool own_z = grid_.mechanism().has_own_z();
  for (std::size_t i = own_z ? height : 0; i <= height; ++i) {
    piece.loose[i] = millimeters(move.loose_z) * grid_.steps_per_mm(i);
  }
  piece.to = grid_.motors_on(move, 0);
  piece.ends_mm[1] = place_at(0);
  double before = 0;
  for (const double part : parts_of(move, length, speed)) {
    piece.from = piece.to;
    piece.to = grid_.motors_on(move, part);
    piece.ends_mm = {piece.ends_mm[1], place_at(part)};
    piece.seconds = length * (part - before) / speed;
    piece.advanced = 0;
    // By the motors: those of a delta also turn where it only goes up.
    const bool prints = piece.to[0] != piece.from[0] || piece.to[1] != piece.from[1];
    for (std::size_t i = 0; i < motor_count; ++i) {
      const double way = piece.to[i] - piece.from[i];
      piece.velocity[i] = piece.seconds > 0 ? way / piece.seconds : 0;
      Course& course = courses[i];
      course.way += std::abs(way);
      if (course.last * way < 0) ++course.turns;
      if (way != 0) course.last = way;
      if (i >= extruder && prints) {
        piece.advanced = std::max(piece.advanced, piece.velocity[i]);
        // Lines and chords end at whole steps of E, by which its speed goes up and down.
        asked_[i] += advance_s_ / advance_window_s * std::min(1.0, 4 * std::abs(way));
      }
    }
    add(piece);
    before = part;
  }
  // An arc may turn in its first and its last piece, too.
  if (!move.arc) return;
  for (const std::size_t axis : {move.arc->first, move.arc->second}) courses[axis].turns += 2;
}

// What is in the shapers together with earlier pieces, with less than the window between them.
void ShapedCheck::add(Piece piece) {
  piece.velocities = {};
  piece.turns = {};
  piece.most_advanced = piece.advanced;
  for (std::size_t i = 0; i < motor_count; ++i) piece.velocities[i].include(piece.velocity[i]);
  piece.reach.reset();
  if (pieces_.empty()) {
    piece.reach = Range{0, 0};
    behind_reach_ = 1;
  }
  pieces_.push_back(piece);
  Piece& added = pieces_.back();
  const double window = window_s_ * (1 - 1e-9);  // the end of a line is as long, but for rounding
  double between = 0;
  for (std::size_t j = pieces_.size() - 1; j > 0 && between < window; --j) {
    Piece& other = pieces_[j - 1];
    for (std::size_t i = 0; i < motor_count; ++i) {
      added.velocities[i].include(other.velocity[i]);
      other.velocities[i].include(added.velocity[i]);
      if (extra_turns_[i] > 0) note_turns(j - 1, i);
    }
    added.most_advanced = std::max(added.most_advanced, other.advanced);
    other.most_advanced = std::max(other.most_advanced, added.advanced);
    between += other.seconds;
  }
  for (std::size_t i = 0; i < motor_count; ++i) {
    if (extra_turns_[i] > 0) note_turns(pieces_.size() - 1, i);
  }
}

// Once for each way.
void ShapedCheck::note_turns(std::size_t piece, std::size_t motor) {
  const Range& velocity = pieces_[piece].velocities[motor];
  if (velocity.low >= 0 || velocity.high <= 0) return;
  if (std::exchange(pieces_[piece].turns[motor], true)) return;
  const auto has_turned = [&](std::size_t other) {
    return pieces_[other].way == pieces_[piece].way && pieces_[other].turns[motor];
  };
  if (piece > 0 && has_turned(piece - 1)) return;
  if (piece + 1 < pieces_.size() && has_turned(piece + 1)) return;
  asked_[motor] += extra_turns_[motor];
}

}  // namespace report
