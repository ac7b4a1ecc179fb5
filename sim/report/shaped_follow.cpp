// SPDX-License-Identifier: Apache-2.0
// Which of the spaces around the lines the steps have gone through, in which order.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "sim/report/shaped_check.hpp"

namespace report {

namespace {

constexpr std::size_t extruder = 3;
// Of a line's Bresenham steps, of the shaper's sum and of its sampling.
constexpr double rounding_steps = 3;
// Shaped motion is a mean of planned motion, which is no faster than F. A tenth more is good all
// the same: this keeps lines in order, and how exactly a chip rounds F is not judged by it.
constexpr double fastest_of_asked = 1.1;
constexpr std::size_t searched_at_once = 32;

}  // namespace

std::optional<ShapedCheck::Range> ShapedCheck::feasible(const Piece& piece,
                                                        const Steps& position) const {
  Range parts{0, 1};
  for (std::size_t i = 0; i < motor_count; ++i) {
    const Range& velocity = piece.velocities[i];
    const double off = rounding_steps + piece.loose[i] +
                       (velocity.high - velocity.low) / 2 * (deviation_s_[i] + slot_s_);
    const double place = static_cast<double>(position[i]);
    double advance = 0;
    if (i >= extruder && piece.most_advanced > 0) {
      // Lines end at whole steps of E, so over this window it may go a step more.
      advance = advance_s_ * (piece.most_advanced + 1 / advance_window_s);
    }
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

// How far it may have come in this time, no faster than that.
void ShapedCheck::go_on(const Steps& position, double seconds) {
  seconds *= fastest_of_asked;
  double left = -1;  // after the piece before
  for (std::size_t i = first_; i < pieces_.size() && (i < behind_reach_ || left >= 0); ++i) {
    Piece& piece = pieces_[i];
    const double before = std::exchange(left, -1);
    if (!piece.reach && before < 0) continue;
    const std::optional<Range> parts = feasible(piece, position);
    if (!parts) continue;
    const auto go = [&](double from, double time) {
      const double there = piece.seconds > 0 ? from + time / piece.seconds : 1;
      if (there >= 1 && parts->high >= 1) left = std::max(left, time - (1 - from) * piece.seconds);
      return std::max(from, std::min({there, parts->high, 1.0}));
    };
    if (piece.reach) piece.reach->high = go(piece.reach->high, seconds);
    if (before >= 0 && parts->low <= 0) {
      const double high = go(0, before);
      piece.reach = Range{0, std::max(high, piece.reach ? piece.reach->high : 0)};
    }
    if (piece.reach) behind_reach_ = std::max(behind_reach_, i + 1);
  }
}

// Of what was reached, where the axes may be now.
bool ShapedCheck::keep_feasible() {
  std::size_t behind = first_;
  for (std::size_t i = first_; i < behind_reach_; ++i) {
    std::optional<Range>& reach = pieces_[i].reach;
    if (!reach) continue;
    const std::optional<Range> parts = feasible(pieces_[i], now_.position);
    if (parts) reach = Range{std::max(reach->low, parts->low), std::min(reach->high, parts->high)};
    if (!parts || reach->low > reach->high) {
      reach.reset();
    } else {
      behind = i + 1;
    }
  }
  if (behind == first_) return false;
  behind_reach_ = behind;
  return true;
}

// Without a further step.
bool ShapedCheck::may_have_ended() const {
  bool goes_on = false;
  for (std::size_t i = first_; i < pieces_.size() && (i < behind_reach_ || goes_on); ++i) {
    const std::optional<Range>& reach = pieces_[i].reach;
    if (!reach && !goes_on) continue;
    const std::optional<Range> parts = feasible(pieces_[i], now_.position);
    const bool enters = goes_on && parts && parts->low <= 0;
    goes_on = parts && parts->high >= 1 && (reach || enters);
  }
  return goes_on;
}

// The next place on the lines at which the axes may be.
bool ShapedCheck::find_again(std::size_t from, std::size_t count) {
  const std::size_t end = std::min(from + count, pieces_.size());
  for (std::size_t i = from; i < end; ++i) {
    const std::optional<Range> parts = feasible(pieces_[i], now_.position);
    if (!parts) continue;
    for (std::size_t j = first_; j < i; ++j) {
      if (pieces_[j].ends_line) miss(pieces_[j].line);
    }
    pieces_[i].reach = parts;
    behind_reach_ = i + 1;
    return true;
  }
  return false;
}

void ShapedCheck::at(const MachineState& state) {
  const MachineState before = std::exchange(now_, state);
  if (first_ == pieces_.size() || (free_ && ended_)) return;
  if (lost_) {
    // Some at each step, so that a long search does not slow down all steps.
    const std::size_t from = first_ + searched_;
    searched_ = from + searched_at_once < pieces_.size() ? searched_ + searched_at_once : 0;
    lost_ = !find_again(from, searched_at_once);
    if (lost_) return;
  } else {
    // As it was, should the track be lost: the line under way is the one that is missed.
    const std::size_t under_way = pieces_[first_].line;
    go_on(before.position, static_cast<double>(now_.clock - before.clock) / clock_hz_);
    if (!keep_feasible()) {
      for (std::size_t i = first_; i < behind_reach_; ++i) pieces_[i].reach.reset();
      miss(under_way);
      searched_ = 0;
      lost_ = !find_again(first_, pieces_.size());
      if (lost_) return;
    }
  }
  std::size_t done = first_;
  while (!pieces_[done].reach) ++done;
  pass(done);
  note_deviation();
  ended_ = is_at_last_target(now_.position) && may_have_ended();
  if (ended_) end_ = now_;
}

// Pieces that are still in the shapers are kept for those that come.
void ShapedCheck::pass(std::size_t count) {
  for (; first_ < count; ++first_) {
    if (pieces_[first_].ends_line) pass_line(pieces_[first_].line);
    passed_s_ += pieces_[first_].seconds;
  }
  while (first_ > 0 && passed_s_ - pieces_.front().seconds > window_s_) {
    passed_s_ -= pieces_.front().seconds;
    pieces_.pop_front();
    --first_;
    --behind_reach_;
  }
  if (first_ == 0) {
    passed_s_ = 0;  // of rounding
  }
}

void ShapedCheck::pass_line(std::size_t line) {
  while (lines_done_ <= line) {
    if (!lines_.front().missed) reached_ += lines_.front().texts.size();
    lines_.pop_front();
    ++lines_done_;
  }
}

void ShapedCheck::miss(std::size_t line) {
  Line& missed = lines_[line - lines_done_];
  if (std::exchange(missed.missed, true)) return;
  for (const RequestedLine& text : missed.texts) missed_.push_back({text, missed.target, now_});
}

void ShapedCheck::note_deviation() {
  const auto place = grid_.place_mm(now_.position);
  std::optional<double> nearest;
  for (std::size_t i = first_; i < behind_reach_; ++i) {
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
  if (!lines_.empty()) {
    for (std::size_t line = lines_done_; line < lines_done_ + lines_.size(); ++line) {
      if (!ended_) miss(line);
    }
    if (ended_) count_unasked();
    pass_line(lines_done_ + lines_.size() - 1);
  } else if (rests) {
    end_ = now_;
    count_unasked();
  }
  restart(now_, last_target_);
}

std::optional<bool> ShapedCheck::rested_at(sim::Clock time) const {
  // Longer than a chip needs for the last part of a step.
  constexpr double certain_s = 0.25;
  if (!ended_) return false;
  if (lines_.empty()) return true;
  const double seconds = static_cast<double>(time - now_.clock) / clock_hz_;
  if (time > now_.clock && seconds > window_s_ + certain_s) return true;
  return std::nullopt;
}

void ShapedCheck::abandon() {
  if (ended_ && !lines_.empty()) {
    count_unasked();
    pass_line(lines_done_ + lines_.size() - 1);
  }
  forget_lines();
}

void ShapedCheck::forget_lines() {
  lines_done_ += lines_.size();
  lines_.clear();
  pieces_.clear();
  first_ = behind_reach_ = searched_ = 0;
  passed_s_ = 0;
}

void ShapedCheck::restart(const MachineState& here, const Steps& meant) {
  forget_lines();
  now_ = rest_ = end_ = here;
  asked_ = {};
  last_target_ = meant;
  last_other_.reset();
  lost_ = free_ = false;
  ended_ = true;
}

std::vector<UnreachedPoint> ShapedCheck::take_missed() { return std::exchange(missed_, {}); }

}  // namespace report
