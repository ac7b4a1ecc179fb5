// SPDX-License-Identifier: Apache-2.0
// The run and its checks.
#include "tests/motion/print_run.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace motion_test {

namespace {

constexpr double rate_unit = 0x1p-64;
constexpr double acceleration_unit = 0x1p-84;

}  // namespace

std::int64_t exact_steps(const units::Position& position, units::StepsPerMeter steps_per_meter) {
  constexpr Wide femtometers_per_meter = 1'000'000'000'000'000;
  const Wide femtometers =
      static_cast<Wide>(position.whole().count()) * 1'000'000 + position.femtometers();
  const Wide product = femtometers * steps_per_meter.count();
  const Wide size = product < 0 ? -product : product;
  const auto steps =
      static_cast<std::int64_t>((size + femtometers_per_meter / 2) / femtometers_per_meter);
  return product < 0 ? -steps : steps;
}

PrintRun::PrintRun(const motion::Limits& limits, const RunOptions& options)
    : limits_(limits),
      options_(options),
      planner_(limits, timing(options.clock_hz, options.least_line_time)),
      model_(options.queue_depth) {
  model_.on_tick = [this](std::uint32_t ticks, const motion::Segment& segment) {
    check_tick(ticks, segment);
  };
  model_.on_segment = [this](const motion::Segment& segment, std::uint64_t rate_before) {
    check_segment(segment, rate_before);
  };
}

RunResult PrintRun::run(const std::vector<motion::LineMove>& moves) {
  const auto clocks_per_refill =
      static_cast<std::uint64_t>(options_.refill_seconds * options_.clock_hz);
  while (fed_ < moves.size() || !planner_.empty() || !model_.idle()) {
    feed(moves);
    if (fed_ == moves.size()) planner_.flush();
    refill();
    let_pass(options_.processor ? options_.processor->pass : clocks_per_refill);
  }
  result_.seconds = static_cast<double>(model_.busy_clocks()) / options_.clock_hz;
  result_.underruns = model_.underruns();
  result_.final_steps = model_.positions();
  return result_;
}

void PrintRun::let_pass(std::uint64_t clocks) {
  for (; clocks > 0; --clocks) model_.clock();
}

// The firmware reads the time once a pass.
void PrintRun::refill() {
  const units::Microseconds began = now();
  while (model_.has_room()) {
    const std::optional<motion::Segment> segment = planner_.next_segment(began);
    if (!segment) break;
    if (options_.processor) {
      let_pass(options_.processor->hand_over / (segment->continues_line ? 10 : 1));
    }
    model_.push(*segment);
  }
}

void PrintRun::feed(const std::vector<motion::LineMove>& moves) {
  const double seconds = static_cast<double>(now().count()) * 1e-6;
  while (fed_ < moves.size() && planner_.has_room()) {
    if (options_.lines_per_second > 0 &&
        static_cast<double>(fed_) > seconds * options_.lines_per_second) {
      return;
    }
    const std::size_t lines = planner_.lines();
    const auto appended = planner_.append(moves[fed_], now());
    if (!appended) throw std::runtime_error(std::string(motion::describe(appended.error())));
    if (planner_.lines() > lines) {
      expected_.push_back({line_end_, moves[fed_].target});
      line_end_ = moves[fed_].target;
    }
    ++fed_;
    if (options_.processor) {
      let_pass(options_.processor->append);
      return;
    }
  }
}

void PrintRun::check_tick(std::uint32_t ticks, const motion::Segment& segment) {
  const ExpectedLine& line = expected_.front();
  const double part = static_cast<double>(ticks) / segment.line_ticks;
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    const auto from = static_cast<double>(line.from[i].whole().count());
    const auto to = static_cast<double>(line.to[i].whole().count());
    const double ideal = (from + (to - from) * part) * 1e-6 / step_mm(i);
    const double deviation = std::abs(ideal - static_cast<double>(model_.positions()[i]));
    result_.worst_deviation_steps = std::max(result_.worst_deviation_steps, deviation);
  }
  result_.worst_distance_steps = std::max(result_.worst_distance_steps, distance_steps(line));
  if (ticks < segment.line_ticks) return;
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    const bool exact =
        model_.positions()[i] == exact_steps(line.to[i], limits_.axes[i].steps_per_meter);
    if (!exact) ++result_.wrong_line_ends;
  }
  expected_.pop_front();
  ++result_.lines;
}

// Of the position on X and Y from the nearest point of the line.
double PrintRun::distance_steps(const ExpectedLine& line) const {
  std::array<double, 2> way{}, gone{};
  for (std::size_t i = 0; i < way.size(); ++i) {
    const auto from = static_cast<double>(line.from[i].whole().count()) * 1e-6 / step_mm(i);
    way[i] = static_cast<double>(line.to[i].whole().count()) * 1e-6 / step_mm(i) - from;
    gone[i] = static_cast<double>(model_.positions()[i]) - from;
  }
  const double square = way[0] * way[0] + way[1] * way[1];
  const double along = way[0] * gone[0] + way[1] * gone[1];
  const double part = square > 0 ? std::clamp(along / square, 0.0, 1.0) : 0.0;
  return std::hypot(gone[0] - part * way[0], gone[1] - part * way[1]);
}

void PrintRun::check_segment(const motion::Segment& segment, std::uint64_t rate_before_bits) {
  ++result_.segments;
  if (rate_before_bits == 0) ++result_.rests;
  const double clock = options_.clock_hz;
  const double rate = static_cast<double>(segment.rate) * rate_unit * clock;
  const double rate_before = static_cast<double>(rate_before_bits) * rate_unit * clock;
  const double acceleration =
      std::abs(static_cast<double>(segment.acceleration)) * acceleration_unit * clock * clock;
  if (segment.continues_line) {
    const double mismatch = std::abs(rate - rate_before) / rate;
    result_.worst_rate_mismatch = std::max(result_.worst_rate_mismatch, mismatch);
  }
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    if (segment.steps[i] == 0) continue;
    const motion::AxisLimits& axis = limits_.axes[i];
    const double speed = std::abs(axis_speed(segment, i, rate));
    const double max_speed = axis.max_speed.count() * 1e-3;
    result_.worst_speed_excess = std::max(result_.worst_speed_excess, speed / max_speed - 1);
    // Rounding may make a step more of the line than its exact distance has.
    const double steps = std::abs(segment.steps[i]);
    if (steps < 2) continue;
    const double allowed = axis.max_acceleration.count() * 1e-3 * steps / (steps - 1);
    const double excess = std::abs(axis_speed(segment, i, acceleration)) / allowed - 1;
    result_.worst_acceleration_excess = std::max(result_.worst_acceleration_excess, excess);
  }
  if (!segment.continues_line) {
    for (std::size_t i = 0; i < units::axis_count; ++i) check_jump(i, segment, rate, rate_before);
  }
  const double speed = std::hypot(axis_speed(segment, 0, rate), axis_speed(segment, 1, rate));
  result_.highest_speed_mm_s = std::max(result_.highest_speed_mm_s, speed);
  if (!segment.continues_line) result_.speeds_mm_s.push_back(speed);
  before_ = segment;
}

// An axis' speed may change by its jerk at a junction, and by what a step more or less in either
// line makes, and from or to rest by the speed that it has in the middle of its first step.
void PrintRun::check_jump(std::size_t axis, const motion::Segment& segment, double rate,
                          double rate_before) {
  double allowed = limits_.axes[axis].jerk.count() * 1e-3;
  const auto tolerate = [&](const motion::Segment& side, double side_rate) {
    if (side_rate == 0) return;
    const double per_step = side_rate / side.line_ticks * step_mm(axis);
    const double clock = options_.clock_hz;
    const double acceleration =
        std::abs(static_cast<double>(side.acceleration)) * acceleration_unit;
    const double first_step = std::abs(axis_speed(side, axis, std::sqrt(acceleration) * clock));
    // A ramp of few ticks is a little slower than allowed, the speed in its first step is not.
    allowed += per_step + 1.02 * first_step;
  };
  tolerate(segment, rate);
  double speed_before = 0;
  if (before_) {
    tolerate(*before_, rate_before);
    speed_before = axis_speed(*before_, axis, rate_before);
  }
  const double jump = std::abs(axis_speed(segment, axis, rate) - speed_before);
  result_.worst_jump_excess_mm_s = std::max(result_.worst_jump_excess_mm_s, jump - allowed);
}

double PrintRun::axis_speed(const motion::Segment& segment, std::size_t axis, double rate) const {
  return rate * segment.steps[axis] / segment.line_ticks * step_mm(axis);
}

double PrintRun::step_mm(std::size_t axis) const {
  return 1e3 / limits_.axes[axis].steps_per_meter.count();
}

units::Microseconds PrintRun::now() const {
  return units::Microseconds(
      static_cast<std::int64_t>(static_cast<double>(model_.clocks()) * 1e6 / options_.clock_hz));
}

}  // namespace motion_test
