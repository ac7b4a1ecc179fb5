// SPDX-License-Identifier: Apache-2.0
// How fast planned motion runs: a person's M220, and pauses in the middle of a move.
#pragma once

#include <cstdint>

#include "application/slope.hpp"
#include "application/tick_clock.hpp"
#include "drivers/step_generator.hpp"
#include "motion/limits.hpp"
#include "units/quantity.hpp"

namespace application {

// Part of the planned speed, in 1/65536; 1 at most, since beyond it the limits of the axes break.
using Stretch = std::uint32_t;

// The step generator stretches the time of what is under way at once, so the path stays and speeds
// fall by the factor s, accelerations by its square.
class Pace {
 public:
  static constexpr Stretch one = 1u << 16;

  // At most `most_lines` are planned and not yet done.
  Pace(drivers::StepGenerator& step_generator, units::Hertz clock, std::uint32_t most_lines)
      : step_generator_(step_generator), slope_(clock, most_lines) {}

  void set_limits(const motion::Limits& limits);
  // A line has been planned, with this feedrate: the slope is one that it allows.
  void note_line(units::MicrometersPerSecond feedrate);
  // All lines that have been planned are done.
  void note_rest();

  Stretch stretch() const { return stretch_; }
  void set_stretch(Stretch stretch);
  // Feed hold: motion comes to rest along its path, and goes on with false.
  void hold(bool held);
  // Homing runs at its own speeds.
  void set_homing(bool homing);

  // The time for the planner: it passes as slowly as motion does. To be called every pass.
  [[gnu::noinline]] units::Microseconds update(units::Microseconds now, bool moving);
  units::Microseconds time() const;

 private:
  void set_scale();

  drivers::StepGenerator& step_generator_;
  Slope slope_;
  Stretch stretch_{one};
  Stretch target_{one};
  Stretch scale_{one};  // at the last update
  bool held_{};
  bool homing_{};
  units::Microseconds last_{};
  std::int64_t time_{};  // in 2^-17 us
};

}  // namespace application
