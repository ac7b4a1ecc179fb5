// SPDX-License-Identifier: Apache-2.0
// Sums over impulses in double, at the end of each slot.
#include "tests/motion/shaping_run.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>

#include "units/magnitude.hpp"

namespace motion_test {

namespace {

constexpr std::size_t extruder = units::index_of(units::Axis::e);

// The planned motion, by the formula of uniform acceleration.
class PlannedMotion {
 public:
  struct Place {
    std::array<double, 4> steps{};
    double printed{};
  };

  void add(const motion::Segment& segment) {
    if (!segment.continues_line) {
      for (std::size_t i = 0; i < 4; ++i) line_start_.steps[i] = end_.steps[i];
      line_start_.printed = end_.printed;
      ticks_before_ = 0;
    }
    const double acceleration = std::ldexp(static_cast<double>(segment.acceleration), -84);
    const double first = std::ldexp(static_cast<double>(segment.rate), -64) - acceleration / 2;
    const double square = first * first + 2 * acceleration * segment.ticks;
    const double last = std::sqrt(std::max(square, 0.0));
    Part part{.begin = clocks_,
              .end = clocks_ + 2 * segment.ticks / (first + last),
              .first_rate = first,
              .acceleration = acceleration,
              .ticks_before = ticks_before_,
              .segment = segment,
              .start = line_start_};
    clocks_ = part.end;
    ticks_before_ += segment.ticks;
    end_ = at_ticks(part, ticks_before_);
    parts_.push_back(part);
  }

  Place at(double clocks) const {
    if (parts_.empty() || clocks <= 0) return {};
    const auto after = std::ranges::upper_bound(parts_, clocks, {}, &Part::begin);
    const Part& part = *std::prev(after);
    if (clocks >= part.end) return at_ticks(part, part.ticks_before + part.segment.ticks);
    const double time = clocks - part.begin;
    return at_ticks(
        part, part.ticks_before + part.first_rate * time + part.acceleration / 2 * time * time);
  }

  const Place& end() const { return end_; }
  double clocks() const { return clocks_; }

 private:
  struct Part {
    double begin, end, first_rate, acceleration, ticks_before;
    motion::Segment segment;
    Place start;
  };

  static Place at_ticks(const Part& part, double ticks) {
    Place place = part.start;
    for (std::size_t i = 0; i < 4; ++i) {
      place.steps[i] += part.segment.steps[i] * ticks / part.segment.line_ticks;
    }
    const auto& steps = part.segment.steps;
    if (steps[extruder] > 0 && (steps[0] != 0 || steps[1] != 0)) {
      place.printed += place.steps[extruder] - part.start.steps[extruder];
    }
    return place;
  }

  std::vector<Part> parts_;
  Place line_start_, end_;
  double clocks_ = 0, ticks_before_ = 0;
};

class Run {
 public:
  explicit Run(const ShapingRunOptions& options)
      : options_(options),
        planner_(options.limits, options.timing),
        witness_(options.limits, options.timing),
        clock_hz_(options.timing.clock.count()) {
    shaping_.set_timing(options.timing);
    shaping_.set_limits(options.limits);
    if (!shaping_.configure(options.settings)) throw std::logic_error("settings out of range");
    for (std::size_t i = 0; i < 2; ++i) {
      impulses_[i] = motion::impulses_of(options.settings.shapers[i], options.timing.clock);
    }
  }

  ShapingRunResult run(const std::vector<motion::LineMove>& moves) {
    std::size_t fed = 0;
    std::uint64_t next_move = 0;
    for (;;) {
      while (fed < moves.size() && planner_.has_room() && result_.slots >= next_move) {
        append(moves[fed++]);
        next_move += options_.slots_per_move;
      }
      if (fed == moves.size()) {
        planner_.flush();
        witness_.flush();
      }
      // As much is in the queue as a pass of the loop may need.
      const auto seconds = static_cast<double>(result_.slots * shaping_.slot_clocks()) / clock_hz_;
      const units::Microseconds now(static_cast<std::int64_t>(seconds * 1e6) + waited_);
      const auto output = shaping_.next_segment(planner_, now, false);
      while (witness_.lines() > planner_.lines() || !witness_.between_lines()) {
        const auto segment = witness_.next_segment(now + slot_time());
        if (!segment) throw std::logic_error("the planners differ");
        planned_.add(*segment);
      }
      if (output.segment.has_value()) {
        see(*output.segment);
      } else if (!output.again) {
        if (fed == moves.size() && planner_.empty() && shaping_.at_rest()) break;
        waited_ += slot_time().count();
        if (options_.slots_per_move != 0 && shaping_.at_rest()) next_move = 0;
      }
    }
    result_.planned_seconds = planned_.clocks() / clock_hz_;
    return result_;
  }

 private:
  units::Microseconds slot_time() const {
    return units::Microseconds(static_cast<std::int64_t>(1e6 * shaping_.slot_clocks() / clock_hz_) +
                               1);
  }

  void append(const motion::LineMove& move) {
    const units::Microseconds now(static_cast<std::int64_t>(
        1e6 * static_cast<double>(result_.slots * shaping_.slot_clocks()) / clock_hz_));
    if (!planner_.append(move, now) || !witness_.append(move, now)) {
      throw std::logic_error("a move is refused");
    }
  }

  void see(const motion::Segment& segment) {
    const double slot = shaping_.slot_clocks();
    ++result_.slots;
    result_.seconds += slot / clock_hz_;
    const auto expected_rate = static_cast<std::uint64_t>(std::ldexp(segment.ticks / slot, 64));
    bool good = segment.rate == expected_rate && segment.ticks == segment.line_ticks &&
                segment.rate <= std::uint64_t{1} << 63 && segment.acceleration == 0 &&
                !segment.continues_line && segment.ticks > 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::uint32_t steps = units::magnitude(segment.steps[i]);
      good &= steps <= segment.line_ticks;
      result_.steps[i] += segment.steps[i];
      result_.worst_rate =
          std::max(result_.worst_rate,
                   steps / (slot / clock_hz_ * options_.timing.max_step_rate[i].count()));
    }
    result_.wrong_slots += good ? 0 : 1;
    const std::int64_t turn = std::int64_t{segment.steps[extruder]} * last_extruder_;
    result_.turns += turn < 0 ? 1 : 0;
    if (segment.steps[extruder] != 0) last_extruder_ = segment.steps[extruder];
    if (options_.against_exact) compare();
    if (!segment.ends_motion) return;
    ++result_.motions;
    for (std::size_t i = 0; i < 4; ++i) {
      if (std::abs(static_cast<double>(result_.steps[i]) - planned_.end().steps[i]) > 1e-6) {
        ++result_.wrong_ends;
      }
    }
  }

  void compare() {
    const double now = static_cast<double>(result_.slots) * shaping_.slot_clocks();
    const double late = now - shaping_.delay_clocks();
    std::array<double, 4> wanted = planned_.at(late).steps;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      wanted[axis] = 0;
      for (std::size_t i = 0; i < impulses_[axis].count; ++i) {
        const motion::Impulse& impulse = impulses_[axis].list[i];
        wanted[axis] += std::ldexp(impulse.weight, -motion::weight_fraction_bits) *
                        planned_.at(late - impulse.delay + impulses_[axis].mean).steps[axis];
      }
    }
    const double window = shaping_.speed_window_clocks();
    if (window != 0) {
      const double printed =
          planned_.at(late + window / 2).printed - planned_.at(late - window / 2).printed;
      wanted[extruder] +=
          options_.settings.advance_microseconds * 1e-6 * clock_hz_ / window * printed;
    }
    for (std::size_t i = 0; i < 4; ++i) {
      result_.worst_distance_steps =
          std::max(result_.worst_distance_steps,
                   std::abs(static_cast<double>(result_.steps[i]) - wanted[i]));
    }
  }

  const ShapingRunOptions& options_;
  motion::Planner planner_, witness_;
  motion::Shaping shaping_;
  double clock_hz_;
  std::array<motion::Impulses, 2> impulses_;
  PlannedMotion planned_;
  std::int64_t waited_ = 0;  // us
  std::int64_t last_extruder_ = 0;
  ShapingRunResult result_;
};

}  // namespace

ShapingRunResult run_shaping(const ShapingRunOptions& options,
                             const std::vector<motion::LineMove>& moves) {
  return Run(options).run(moves);
}

}  // namespace motion_test
