// SPDX-License-Identifier: Apache-2.0
// Spaces around the lines, and which of them the steps have gone through.
#include "sim/report/shaped_check.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace report {

namespace {

constexpr std::size_t extruder = 3;
// Of a line's Bresenham steps, of the shaper's sum and of its sampling.
constexpr double rounding_steps = 3;
// Over which linear advance takes the velocity of E.
constexpr double advance_window_s = 0.020;
// Lines, and chords of others, end at whole steps of E: in that time its way is off by so much.
constexpr double advanced_rounding_steps = 1;
// Positions are sampled once a slot, and one between samples is made of those about it.
constexpr double slots_about_sample = 3;
// Arcs, and lines on which motors do not go evenly, in pieces that are straight to less than a step.
constexpr double longest_piece_mm = 0.5, arc_deviation_mm = 0.001;

double length_of(const Move& move) {
  std::array<double, 3> way{};
  for (std::size_t i = 0; i < way.size(); ++i) way[i] = millimeters(move.to[i] - move.from[i]);
  if (move.arc) {
    way[move.arc->first] = move.arc->length_mm();
    way[move.arc->second] = 0;
  }
  const double length = std::hypot(way[0], way[1], way[2]);
  if (length > 0) return length;
  double filament = 0;
  for (std::size_t i = extruder; i < motor_count; ++i) {
    filament += std::abs(millimeters(move.to[i] - move.from[i]));
  }
  return filament;
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
  for (std::size_t i = 0; i < setting.shapers.size(); ++i) {
    const ShaperTimes times = times_of(setting.shapers[i]);
    deviation_s_[i] = times.deviation_s;
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

void ShapedCheck::ask(const std::vector<Move>& parts, RequestedLine line, const Steps& target,
                      const std::optional<Steps>& other) {
  Motors ways{};
  for (std::size_t i = 0; i < motor_count; ++i) {
    ways[i] = static_cast<double>(std::llabs(target[i] - last_target_[i]));
  }
  lines_.push_back({std::move(line), target});
  last_target_ = target;
  last_other_ = other;
  ended_ = false;
  Motors pieces_ways{};
  for (const Move& part : parts) add_pieces(part, pieces_ways);
  pieces_.back().ends_line = true;
  for (std::size_t i = 0; i < motor_count; ++i) {
    // Where it turns on its way, a step more on either side.
    if (pieces_ways[i] > ways[i] + 1) ways[i] = pieces_ways[i] + 2;
    asked_[i] += ways[i];
    // Linear advance goes there and back.
    if (i >= extruder) asked_[i] += 2 * advance_s_ * pieces_.back().advanced;
  }
  at(now_);
}

void ShapedCheck::add_pieces(const Move& move, Motors& ways) {
  const double length = length_of(move);
  const double speed = move.speed_mm_s > 0 ? move.speed_mm_s : fastest_mm_s_;
  const auto place_at = [&](double part) {
    const auto place = MotorGrid::place_on(move, part);
    return std::array{place[0], place[1]};
  };
  Piece piece;
  piece.line = lines_done_ + lines_.size() - 1;
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
      ways[i] += std::abs(way);
      if (i >= extruder && prints) {
        piece.advanced = std::max(piece.advanced, piece.velocity[i]);
        // Linear advance goes to and fro by what rounding changes at the end of each chord.
        const double rounding = advanced_rounding_steps * std::min(1.0, 4 * std::abs(way));
        asked_[i] += advance_s_ / advance_window_s * rounding;
      }
    }
    add(piece);
    before = part;
  }
}

// What is in the shapers together with earlier pieces, with no more than the window between them.
void ShapedCheck::add(Piece piece) {
  piece.velocities = {};
  piece.most_advanced = piece.advanced;
  for (std::size_t i = 0; i < motor_count; ++i) piece.velocities[i].include(piece.velocity[i]);
  double between = 0;
  for (std::size_t j = pieces_.size(); j > 0 && between <= window_s_; --j) {
    Piece& other = pieces_[j - 1];
    for (std::size_t i = 0; i < motor_count; ++i) {
      piece.velocities[i].include(other.velocity[i]);
      other.velocities[i].include(piece.velocity[i]);
    }
    piece.most_advanced = std::max(piece.most_advanced, other.advanced);
    other.most_advanced = std::max(other.most_advanced, piece.advanced);
    between += other.seconds;
  }
  piece.reach.reset();
  if (pieces_.empty()) piece.reach = Range{0, 0};
  pieces_.push_back(piece);
}

std::optional<ShapedCheck::Range> ShapedCheck::feasible(const Piece& piece) const {
  Range parts{0, 1};
  for (std::size_t i = 0; i < motor_count; ++i) {
    const Range& velocity = piece.velocities[i];
    double off = rounding_steps + (velocity.high - velocity.low) / 2 * (deviation_s_[i] + slot_s_);
    if (i >= extruder) off += advance_s_ / advance_window_s * advanced_rounding_steps;
    const double place = static_cast<double>(now_.position[i]);
    const double advance = i >= extruder ? advance_s_ * piece.most_advanced : 0;
    const double least = place - off - advance - piece.from[i];
    const double most = place + off - piece.from[i];
    const double way = piece.to[i] - piece.from[i];
    if (std::abs(way) < 1e-9) {
      if (least > 0 || most < 0) return std::nullopt;
      continue;
    }
    parts.low = std::max(parts.low, (way > 0 ? least : most) / way);
    parts.high = std::min(parts.high, (way > 0 ? most : least) / way);
  }
  if (parts.low > parts.high) return std::nullopt;
  return parts;
}

// From what was reached on, as far as the axes may be where they are without a gap.
bool ShapedCheck::follow() {
  bool enters = false, any = false;
  for (std::size_t i = first_; i < pieces_.size(); ++i) {
    Piece& piece = pieces_[i];
    if (!piece.reach && !enters) continue;
    const std::optional<Range> parts = feasible(piece);
    std::optional<Range> reach;
    if (parts && piece.reach) {
      const double low = std::max(piece.reach->low, parts->low);
      if (low <= std::min(piece.reach->high, parts->high)) reach = Range{low, parts->high};
    }
    if (parts && enters && parts->low <= 0) reach = Range{0, parts->high};
    piece.reach = reach;
    enters = reach && reach->high >= 1;
    any = any || reach;
  }
  return any;
}

// The next place on the lines at which the axes may be.
bool ShapedCheck::find_again() {
  for (std::size_t i = first_; i < pieces_.size(); ++i) {
    const std::optional<Range> parts = feasible(pieces_[i]);
    if (!parts) continue;
    for (std::size_t j = first_; j < i; ++j) {
      if (pieces_[j].ends_line) miss(pieces_[j].line);
    }
    pieces_[i].reach = parts;
    return true;
  }
  return false;
}

void ShapedCheck::at(const MachineState& state) {
  now_ = state;
  if (first_ == pieces_.size() || (free_ && ended_)) return;
  if (lost_) {
    lost_ = !find_again();
    if (lost_) return;
  }
  // As it was, should the track be lost: the line under way is the one that is missed.
  const std::size_t under_way = pieces_[first_].line;
  if (!follow()) {
    miss(under_way);
    lost_ = !find_again();
    if (lost_) return;
    follow();
  }
  std::size_t done = first_;
  while (!pieces_[done].reach) ++done;
  pass(done);
  note_deviation();
  ended_ =
      pieces_.back().reach && pieces_.back().reach->high >= 1 && is_at_last_target(now_.position);
  if (ended_) end_ = now_;
}

// Pieces that are still in the shapers are kept for those that come.
void ShapedCheck::pass(std::size_t count) {
  for (; first_ < count; ++first_) {
    if (pieces_[first_].ends_line) pass_line(pieces_[first_].line);
  }
  double kept = 0;
  for (const Piece& piece : pieces_) kept += piece.seconds;
  for (std::size_t i = first_; i < pieces_.size(); ++i) kept -= pieces_[i].seconds;
  while (first_ > 0 && kept - pieces_.front().seconds > window_s_) {
    kept -= pieces_.front().seconds;
    pieces_.pop_front();
    --first_;
  }
}

void ShapedCheck::pass_line(std::size_t line) {
  while (lines_done_ <= line) {
    if (!lines_.front().missed) ++reached_;
    lines_.pop_front();
    ++lines_done_;
  }
}

void ShapedCheck::miss(std::size_t line) {
  Line& missed = lines_[line - lines_done_];
  if (std::exchange(missed.missed, true)) return;
  missed_.push_back({missed.text, missed.target, now_});
}

void ShapedCheck::note_deviation() {
  const auto place = grid_.place_mm(now_.position);
  std::optional<double> nearest;
  for (std::size_t i = first_; i < pieces_.size(); ++i) {
    const Piece& piece = pieces_[i];
    if (!piece.reach) continue;
    const auto& [from, to] = piece.ends_mm;
    const double x = to[0] - from[0], y = to[1] - from[1];
    const double square = x * x + y * y;
    const double part =
        square > 0
            ? std::clamp(((place[0] - from[0]) * x + (place[1] - from[1]) * y) / square, 0.0, 1.0)
            : 0;
    const double off = std::hypot(from[0] + part * x - place[0], from[1] + part * y - place[1]);
    nearest = std::min(nearest.value_or(off), off);
  }
  max_deviation_mm_ = std::max(max_deviation_mm_, nearest.value_or(0));
}

void ShapedCheck::count_unasked() {
  for (std::size_t i = 0; i < motor_count; ++i) {
    const auto asked = static_cast<std::int64_t>(std::ceil(asked_[i]));
    const std::int64_t made = end_.steps_made[i] - rest_.steps_made[i];
    unasked_[i] += std::max<std::int64_t>(0, made - asked);
  }
}

void ShapedCheck::settle(bool rests) {
  if (rests) at(now_);
  if (!lines_.empty()) {
    for (std::size_t line = lines_done_; line < lines_done_ + lines_.size(); ++line) {
      if (!ended_) miss(line);
    }
    if (ended_) count_unasked();
    pass_line(lines_done_ + lines_.size() - 1);
  }
  restart(now_, last_target_);
}

void ShapedCheck::abandon() {
  if (ended_ && !lines_.empty()) pass_line(lines_done_ + lines_.size() - 1);
  lines_done_ += lines_.size();
  lines_.clear();
  pieces_.clear();
  first_ = 0;
}

void ShapedCheck::restart(const MachineState& here, const Steps& meant) {
  lines_done_ += lines_.size();
  lines_.clear();
  pieces_.clear();
  first_ = 0;
  now_ = rest_ = end_ = here;
  asked_ = {};
  last_target_ = meant;
  last_other_.reset();
  lost_ = free_ = false;
  ended_ = true;
}

std::vector<UnreachedPoint> ShapedCheck::take_missed() { return std::exchange(missed_, {}); }

}  // namespace report
