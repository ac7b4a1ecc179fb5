// SPDX-License-Identifier: Apache-2.0
// Jerk per axis, and the circles of the junction deviation.
#include "motion/junction.hpp"

#include <algorithm>

#include "units/loop_bound.hpp"
#include "units/magnitude.hpp"

namespace motion {

namespace {

using units::magnitude;

constexpr std::size_t extruder = units::index_of(units::Axis::e);

// The highest speed, not above `speed`, at which no axis from `first` on changes its speed by more
// than its jerk when the path's direction changes by `change`.
units::MicrometersPerSecond jerk_limited_speed(const Direction& change, std::size_t first,
                                               const Limits& limits,
                                               units::MicrometersPerSecond speed) {
  auto limited = static_cast<std::uint32_t>(speed.count());
  units::LoopBound<units::axis_count> axes;
  for (std::size_t i = first; i < units::axis_count; ++i) {
    axes.next();
    const std::uint32_t part = magnitude(change[i]);
    const auto most = static_cast<std::uint64_t>(limits.axes[i].jerk.count())
                      << direction_fraction_bits;
    if (std::uint64_t{limited} * part > most) {
      limited = static_cast<std::uint32_t>((Scaled::of(most) / Scaled::of_word(part)).floor());
    }
  }
  return units::MicrometersPerSecond(static_cast<std::int32_t>(limited));
}

Direction change_between(const Direction& before, const Direction& after) {
  Direction change{};
  for (std::size_t i = 0; i < change.size(); ++i) change[i] = after[i] - before[i];
  return change;
}

// Half the angle of the turn has this sine, squared.
Scaled sine_square(const Direction& change) {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < extruder; ++i) {
    const std::uint64_t part = magnitude(change[i]);
    sum += part * part;
  }
  return Scaled::of(sum, -2 * direction_fraction_bits - 2);
}

SpecificEnergy energy_round_corner(Scaled sine_square, Scaled cosine_square, const Course& before,
                                   const Course& after, units::Nanometers deviation) {
  const auto of_energy = [](Scaled energy) { return SpecificEnergy(energy.floor()); };
  const Scaled cosine = cosine_square.square_root();
  const Scaled ratio = cosine / sine_square;
  // acceleration * radius / 2, with radius = deviation * cosine / (1 - cosine)
  constexpr int bits = 31;
  const Scaled one_and_cosine = Scaled::of((std::uint64_t{1} << bits) + cosine.floor(bits), -bits);
  const auto acceleration = std::min(before.acceleration, after.acceleration);
  const Scaled work_of_deviation = Scaled::of(static_cast<std::uint32_t>(acceleration.count())) *
                                   Scaled::of(static_cast<std::uint64_t>(deviation.count()));
  const Scaled of_corner = (work_of_deviation * ratio * one_and_cosine).half();
  // acceleration * radius / 2, with radius = length / 2 * cosine / sine
  const Scaled work = Scaled::of(std::min(before.work, after.work).count());
  const Scaled of_curve = (work * (cosine * ratio).square_root()).half().half();
  return std::min(of_energy(of_corner), of_energy(of_curve));
}

}  // namespace

SpecificEnergy junction_energy(const Course& before, const Course& after, const Limits& limits) {
  const units::MicrometersPerSecond shared = std::min(before.speed, after.speed);
  const Direction change = change_between(before.direction, after.direction);
  const bool by_deviation = limits.junction_deviation != units::Nanometers() &&
                            !before.extruder_leads && !after.extruder_leads;
  const SpecificEnergy by_jerk =
      energy_of(jerk_limited_speed(change, by_deviation ? extruder : 0, limits, shared));
  if (!by_deviation) return by_jerk;
  const Scaled sine = sine_square(change);
  if (sine == Scaled()) return by_jerk;
  constexpr int bits = 2 * direction_fraction_bits;
  constexpr std::uint64_t one = std::uint64_t{1} << bits;
  const std::uint64_t sine_bits = sine.floor(bits);
  if (sine_bits >= one) return {};
  const Scaled cosine = Scaled::of(one - sine_bits, -bits);
  return std::min(by_jerk,
                  energy_round_corner(sine, cosine, before, after, limits.junction_deviation));
}

SpecificEnergy energy_from_rest(const Course& course, const Limits& limits) {
  if (limits.junction_deviation != units::Nanometers() && !course.extruder_leads) return {};
  return energy_of(jerk_limited_speed(course.direction, 0, limits, course.speed));
}

}  // namespace motion
