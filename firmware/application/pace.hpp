// SPDX-License-Identifier: Apache-2.0
// How fast motion runs of what was planned: M220, and pauses in the middle of a move.
#pragma once

#include <cstdint>

#include "application/tick_clock.hpp"
#include "drivers/step_generator.hpp"
#include "motion/limits.hpp"
#include "units/quantity.hpp"

namespace application {

// Slowing down is the step generator's work: it stretches the time of what is under way at once, so
// the path stays and speeds fall by the factor s, accelerations by its square. Speeding up is the
// planner's, for the lines that are still to come: stretching would break the limits of the axes.
class Pace {
 public:
  Pace(drivers::StepGenerator& step_generator, units::Hertz clock)
      : step_generator_(step_generator), clock_(clock) {}

  // The scale goes down and up so fast that the change alone takes no axis beyond the acceleration
  // that the planner leaves it: the slope is the least of (limit - planned) / speed over the axes,
  // at their highest speeds. An axis that is planned with more than 3/4 of its limit gets a quarter
  // of it beside, so that it may exceed its limit by a quarter while the scale changes.
  void set_limits(const motion::Limits& limits);

  // M220. Returns the percentage that is left to the planner: 100 or more where the step generator
  // stretches time, all of it otherwise.
  std::int32_t set_speed(std::int32_t percent);
  // Feed hold: motion comes to rest along its path, and goes on with false.
  void hold(bool held);
  // Homing runs at its own speeds.
  void set_homing(bool homing);

  // The time for the planner: it passes as slowly as motion does. To be called every pass.
  units::Microseconds update(units::Microseconds now, bool moving);
  units::Microseconds time() const;

 private:
  static constexpr std::uint32_t one = 1u << 16;

  void set_scale();

  drivers::StepGenerator& step_generator_;
  units::Hertz clock_;
  std::uint32_t speed_{one};  // of M220, up to 1
  std::uint32_t target_{one};
  std::uint32_t scale_{one};  // at the last update
  bool held_{};
  bool homing_{};
  units::Microseconds last_{};
  std::int64_t time_{};  // in 2^-17 us
};

}  // namespace application
