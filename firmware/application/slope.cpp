// SPDX-License-Identifier: Apache-2.0
// The strictest limits of the lines that may still be executed.
#include "application/slope.hpp"

#include <algorithm>

namespace application {
namespace {

constexpr std::size_t extruder = units::index_of(units::Axis::e);
constexpr int slope_fraction_bits = 32;

std::uint32_t count_of(auto quantity) { return static_cast<std::uint32_t>(quantity.count()); }

// The slope with which this speed changes by this acceleration, in 2^-32 per clock.
std::uint32_t slope_of(std::uint32_t acceleration, std::uint32_t speed, units::Hertz clock) {
  const std::uint64_t change = std::uint64_t{acceleration} << slope_fraction_bits;
  const std::uint64_t slope =
      change / (std::uint64_t{std::max<std::uint32_t>(speed, 1)} * clock.count());
  return static_cast<std::uint32_t>(std::clamp<std::uint64_t>(slope, 1, 0x7FFF'FFFF));
}

}  // namespace

void Slope::Strictest::include(const Strictest& other) {
  speed = std::max(speed, other.speed);
  acceleration = std::min(acceleration, other.acceleration);
  axis_slope = std::min(axis_slope, other.axis_slope);
}

void Slope::set_limits(const motion::Limits& limits) {
  limits_ = {};
  limits_.acceleration = count_of(std::min(limits.print_acceleration, limits.travel_acceleration));
  least_speed_ = count_of(std::max(limits.min_print_speed, limits.min_travel_speed));
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    const motion::AxisLimits& axis = limits.axes[i];
    const std::uint32_t speed = count_of(axis.max_speed);
    auto acceleration = axis.max_acceleration;
    // Where E leads a line, its speed and acceleration are those of the path.
    if (i == extruder) {
      acceleration = std::min(acceleration, limits.retract_acceleration);
    } else {
      limits_.speed += speed;
    }
    const std::uint32_t slope = application::slope_of(count_of(acceleration), speed, clock_);
    limits_.axis_slope = std::min(limits_.axis_slope, slope);
  }
}

std::optional<std::uint32_t> Slope::note_line(units::MicrometersPerSecond feedrate) {
  if (++lines_here_ > most_lines_) {
    lines_here_ = 1;
    before_ = here_;
    here_ = {};
  }
  Strictest line = limits_;
  line.speed = std::min(limits_.speed, std::max(least_speed_, count_of(feedrate)));
  here_.include(line);
  Strictest all = here_;
  all.include(before_);
  if (in_force_ == all) return std::nullopt;
  in_force_ = all;
  return slope_of(all);
}

std::uint32_t Slope::slope_of(const Strictest& lines) const {
  return std::min(lines.axis_slope, application::slope_of(lines.acceleration, lines.speed, clock_));
}

}  // namespace application
