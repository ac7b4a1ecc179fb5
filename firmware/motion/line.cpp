// SPDX-License-Identifier: Apache-2.0
// The geometry of lines: lengths, directions, and their speed and acceleration under the
// axes' limits.
#include "motion/line.hpp"

#include <algorithm>
#include <bit>
#include <limits>

#include "motion/s_curve.hpp"
#include "units/loop_bound.hpp"
#include "units/magnitude.hpp"

namespace motion {

namespace {

using units::magnitude;

constexpr std::size_t extruder = units::index_of(units::Axis::e);
// Lines of so few ticks may count as long as their steps are: see make_line.
constexpr std::uint32_t few_ticks = 4;
// E leads a line on which it moves this many times as far as X, Y and Z (as a power of 2):
// direction_ fraction_bits leave room for it, and no axis limit of X, Y or Z matters there.
constexpr int extruder_leads_bits = 5;
// Acceleration of a segment, in ticks per clock^2: format and some room for it, see Segment.
constexpr int max_acceleration_exponent = -22;
constexpr Scaled one = Scaled::of_word(1);
constexpr SpecificEnergy max_work{std::uint64_t{1} << 60};

units::MicrometersPerSecond at_least_slowest(Scaled speed) {
  return units::MicrometersPerSecond(
      static_cast<std::int32_t>(std::max<std::uint64_t>(speed.floor(), 1)));
}

// By 0 .. 31 bits, without the call that is made for more.
std::uint64_t shifted_right(std::uint64_t value, int bits) {
  const auto high = static_cast<std::uint32_t>(value >> 32);
  const std::uint32_t low = static_cast<std::uint32_t>(value) >> bits | high << (31 - bits) << 1;
  return std::uint64_t{high >> bits} << 32 | low;
}

Scaled scaled(std::int32_t positive) {
  return Scaled::of_word(static_cast<std::uint32_t>(positive));
}

// Of X, Y and Z, each below 2^31 nm.
Scaled length_of_words(const units::PerAxis<units::Nanometers>& distance) {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < extruder; ++i) {
    const auto side = static_cast<std::int32_t>(distance[i].count());
    sum += static_cast<std::uint64_t>(std::int64_t{side} * side);
  }
  return Scaled::of(sum).square_root();
}

// Of X, Y and Z, in nm. The squares of up to 31 bits are exact; longer distances are halved first.
Scaled spatial_length(const units::PerAxis<units::Nanometers>& distance) {
  std::uint64_t any = 0;
  for (std::size_t i = 0; i < extruder; ++i) any |= magnitude(distance[i].count());
  if (any >> 31 == 0) return length_of_words(distance);
  const int shift = static_cast<int>(std::bit_width(any)) - 31;
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < extruder; ++i) {
    const std::uint64_t side = static_cast<std::uint32_t>(magnitude(distance[i].count()) >> shift);
    sum += side * side;
  }
  return Scaled::of(sum, 2 * shift).square_root();
}

}  // namespace

Geometry::Geometry(const Limits& limits, const StepTiming& timing)
    : limits_(limits), clock_(timing.clock) {
  const Scaled clock = Scaled::of(timing.clock.count());
  // The step generator makes at most a tick every second clock.
  const std::uint64_t highest_tick_rate = timing.clock.count() / 2;
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    const AxisLimits& axis = limits.axes[i];
    if (axis.steps_per_meter.count() <= 0 || axis.max_speed.count() <= 0) continue;
    const auto steps_per_meter = static_cast<std::uint64_t>(axis.steps_per_meter.count());
    const auto speed = static_cast<std::uint64_t>(axis.max_speed.count());
    const std::uint64_t axis_rate = std::max<std::uint64_t>(steps_per_meter * speed / 1'000'000, 1);
    const std::uint64_t driver_rate = std::max<std::uint64_t>(timing.max_step_rate[i].count(), 1);
    const std::uint64_t rate = std::min({axis_rate, driver_rate, highest_tick_rate});
    time_per_step_[i] = Scaled::of(1'000) / Scaled::of(rate);
    length_per_step_[i] = Scaled::of(1'000'000'000) / Scaled::of(steps_per_meter);
  }
  longest_exponent_ = std::ranges::max(time_per_step_).exponent();
  rate_factor_ = Scaled::of(2'000).square_root() / clock;
  max_tick_acceleration_ =
      clock * clock * Scaled::of(1, max_acceleration_exponent) / Scaled::of(1'000);
}

Geometry::Path Geometry::path_of(const Displacement& displacement,
                                 units::MicrometersPerSecond feedrate) const {
  const units::PerAxis<units::Nanometers>& distance = displacement.distance;
  const Scaled spatial = spatial_length(distance);
  const std::uint64_t extruded = magnitude(distance[extruder].count());
  Path path{.length = spatial,
            .inverse = {},
            .extruder_leads = extruded != 0 && Scaled::of(extruded, -extruder_leads_bits) > spatial,
            .direction = {},
            .feedrate = feedrate,
            .acceleration = {}};
  if (path.extruder_leads) {
    path.length = Scaled::of(extruded);
    if (spatial != Scaled()) {
      const Scaled speed = scaled(feedrate.count()) * path.length / spatial;
      path.feedrate = units::MicrometersPerSecond(static_cast<std::int32_t>(
          std::min<std::uint64_t>(speed.floor(), static_cast<std::uint32_t>(max_speed.count()))));
    }
  }
  const bool prints = extruded != 0;
  path.feedrate =
      std::max(path.feedrate, prints ? limits_.min_print_speed : limits_.min_travel_speed);
  path.acceleration = path.extruder_leads ? limits_.retract_acceleration
                      : prints            ? limits_.print_acceleration
                                          : limits_.travel_acceleration;
  path.inverse = one / path.length;
  units::LoopBound<units::axis_count> axes;
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    axes.next();
    const std::uint64_t all = magnitude(distance[i].count());
    if (all == 0) continue;
    const std::uint32_t size =
        all >> 32 == 0 ? path.inverse.floor_of_product(static_cast<std::uint32_t>(all),
                                                       direction_fraction_bits)
                       : static_cast<std::uint32_t>(
                             (Scaled::of(all) * path.inverse).floor(direction_fraction_bits));
    const auto part = static_cast<std::int32_t>(size);
    path.direction[i] = distance[i].count() < 0 ? -part : part;
  }
  return path;
}

Course Geometry::make_line(const Displacement& displacement, units::MicrometersPerSecond feedrate,
                           units::Microseconds least_time, Line& line) const {
  const Path path = path_of(displacement, feedrate);
  line.steps = displacement.steps;
  const std::uint32_t ticks = line.ticks();
  Course result{.ticks = ticks,
                .direction = path.direction,
                .speed = path.feedrate,
                .acceleration = {},
                .work = {},
                .extruder_leads = path.extruder_leads};
  const Scaled time_of_steps = this->time_of_steps(displacement);
  Scaled length = path.length;
  Scaled speed = scaled(result.speed.count());
  const Scaled least_length = speed * time_of_steps;
  if (least_length > length) {
    // A line shorter than its rounded steps has them in too short a time. That is only a matter of
    // rounding, and no reason to slow down: it counts as longer, but not as longer than its steps.
    length = std::max(length, std::min(least_length, length_of_few_steps(line, path)));
    if (least_length > length) {
      result.speed = at_least_slowest(length / time_of_steps);
      speed = scaled(result.speed.count());
    }
  }
  constexpr Scaled thousand = Scaled::of_word(1'000);
  const Scaled microseconds_times_speed = thousand * length;
  // At most 100 ms (Supply). Compared as a product: of the two quotients only one is needed.
  const Scaled least = Scaled::of_word(static_cast<std::uint32_t>(least_time.count()));
  units::Microseconds nominal_time = least_time;
  if (speed * least > microseconds_times_speed) {
    result.speed = at_least_slowest(microseconds_times_speed / least);
  } else {
    const Scaled time = microseconds_times_speed / speed;
    nominal_time =
        std::max(least_time, units::Microseconds(static_cast<std::int64_t>(time.floor())));
  }
  const units::Microseconds most_time = longest_tick * ticks;
  if (nominal_time > most_time) {
    result.speed = at_least_slowest(microseconds_times_speed /
                                    Scaled::of(static_cast<std::uint64_t>(most_time.count())));
    nominal_time = most_time;
  }
  constexpr units::Microseconds longest_time{std::numeric_limits<std::uint32_t>::max()};
  line.least_time_us = static_cast<std::uint32_t>(std::min(nominal_time, longest_time).count());
  const Scaled inverse = length == path.length ? path.inverse : one / length;
  const Scaled ticks_per_length = Scaled::of_word(ticks) * inverse;
  result.acceleration = limited_acceleration(path, ticks_per_length);
  const std::uint64_t work = (scaled(result.acceleration.count()) * length).floor();
  line.work = std::clamp(SpecificEnergy(work), SpecificEnergy(1), max_work);
  result.work = line.work;
  // The acceleration of such ramps is twice their mean one at most.
  if (s_curve_in_image && limits_.s_curve) {
    line.work = std::max(SpecificEnergy(line.work / 2), SpecificEnergy(1));
  }
  const Scaled rate_of_root = rate_factor_ * ticks_per_length;
  line.rate_mantissa = rate_of_root.mantissa();
  line.rate_exponent = static_cast<std::int8_t>(rate_of_root.exponent());
  line.speed = result.speed;
  return result;
}

// The time of the axis that takes longest, as exactly as times of the slowest axis are. Steps take
// from 1 s to 20 ns and less, which 31 bits cover.
Scaled Geometry::time_of_steps(const Displacement& displacement) const {
  std::uint64_t longest = 0, compared = 0;
  int exponent = 0;
  units::LoopBound<units::axis_count> axes;
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    axes.next();
    const std::uint32_t steps = magnitude(displacement.steps[i]);
    if (steps == 0) continue;
    const Scaled& step = time_per_step_[i];
    const std::uint64_t time = step.product_of_mantissa(steps);
    if (time == 0) continue;
    const std::uint64_t in_common = shifted_right(time, longest_exponent_ - step.exponent());
    if (in_common < compared) continue;
    compared = in_common;
    longest = time;
    exponent = step.exponent();
  }
  return Scaled::of(longest, exponent);
}

Scaled Geometry::length_of_few_steps(const Line& line, const Path& path) const {
  Scaled length;
  if (line.ticks() > few_ticks) return length;
  const std::size_t axes = path.extruder_leads ? units::axis_count : extruder;
  units::LoopBound<units::axis_count> bound;
  for (std::size_t i = 0; i < axes; ++i) {
    bound.next();
    length = std::max(length, Scaled::of_word(magnitude(line.steps[i])) * length_per_step_[i]);
  }
  return length;
}

units::MicrometersPerSecondSquared Geometry::limited_acceleration(const Path& path,
                                                                  Scaled ticks_per_length) const {
  auto acceleration = static_cast<std::uint32_t>(path.acceleration.count());
  units::LoopBound<units::axis_count> axes;
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    axes.next();
    const std::uint32_t part = magnitude(path.direction[i]);
    const auto most = static_cast<std::uint64_t>(limits_.axes[i].max_acceleration.count())
                      << direction_fraction_bits;
    if (std::uint64_t{acceleration} * part > most) {
      acceleration = static_cast<std::uint32_t>((Scaled::of(most) / Scaled::of_word(part)).floor());
    }
  }
  if (Scaled::of_word(acceleration) * ticks_per_length > max_tick_acceleration_) {
    acceleration = static_cast<std::uint32_t>((max_tick_acceleration_ / ticks_per_length).floor());
  }
  return units::MicrometersPerSecondSquared(
      static_cast<std::int32_t>(std::max<std::uint32_t>(acceleration, 1)));
}

}  // namespace motion
