// SPDX-License-Identifier: Apache-2.0
// Limits of axes and of motors along a line.
#include "motion/kinematics/path_limits.hpp"

#include <algorithm>

#include "units/loop_bound.hpp"
#include "units/magnitude.hpp"

namespace motion::kinematics {

namespace {

using units::magnitude;

// Up to 1 m.
Scaled length_of(const units::PerAxis<units::Nanometers>& distance) {
  std::uint64_t sum = 0;
  units::LoopBound<spatial_axes> axes;
  for (std::size_t i = 0; i < spatial_axes; ++i) {
    axes.next();
    const std::uint64_t size = magnitude(distance[i].count());
    sum += size * size;
  }
  return Scaled::of(sum).square_root();
}

}  // namespace

units::MicrometersPerSecond speed_of_axes(const Limits& limits, const Place& from,
                                          const Place& to) {
  units::PerAxis<units::Nanometers> distance{};
  for (std::size_t i = 0; i < spatial_axes; ++i) distance[i] = (to[i] - from[i]).nearest();
  const Scaled length = length_of(distance);
  Scaled speed = Scaled::of(magnitude(max_speed.count()));
  units::LoopBound<spatial_axes, 1> axes;
  for (std::size_t i = 0; i < spatial_axes; ++i) {
    axes.next();
    const std::uint64_t part = magnitude(distance[i].count());
    if (part == 0) continue;
    const Scaled most = Scaled::of(magnitude(limits.axes[i].max_speed.count()));
    speed = std::min(speed, most * length / Scaled::of(part));
  }
  return units::MicrometersPerSecond(
      static_cast<std::int32_t>(std::max<std::uint64_t>(speed.floor(), 1)));
}

void limit_to_motors(const Limits& limits, const Displacement& displacement, Line& line,
                     Course& course) {
  const Scaled length = length_of(displacement.distance);
  if (course.extruder_leads || length == Scaled()) return;
  Scaled acceleration = Scaled::of(magnitude(course.acceleration.count()));
  const Scaled before = acceleration;
  units::LoopBound<spatial_axes, 2> motors;
  for (std::size_t i = 0; i < spatial_axes; ++i) {
    motors.next();
    const AxisLimits& motor = limits.axes[i];
    const std::uint32_t steps = magnitude(displacement.steps[i]);
    if (steps == 0) continue;
    const Scaled way = Scaled::of(std::uint64_t{steps} * 1'000'000'000) /
                       Scaled::of(magnitude(motor.steps_per_meter.count()));
    const Scaled most = Scaled::of(magnitude(motor.max_acceleration.count()));
    acceleration = std::min(acceleration, most * length / way);
  }
  if (acceleration == before) return;
  const std::uint64_t limited = std::max<std::uint64_t>(acceleration.floor(), 1);
  const Scaled work = Scaled::of(line.work.count()) * Scaled::of(limited) / before;
  course.acceleration = units::MicrometersPerSecondSquared(static_cast<std::int32_t>(limited));
  line.work = std::max(SpecificEnergy(work.floor()), SpecificEnergy(1));
  course.work = line.work;
}

}  // namespace motion::kinematics
