// SPDX-License-Identifier: Apache-2.0
// One straight line of the planner: its steps, speed and acceleration limits.
#pragma once

#include <algorithm>
#include <cstdint>

#include "motion/limits.hpp"
#include "motion/scaled.hpp"
#include "motion/segment.hpp"
#include "motion/steps.hpp"
#include "units/axes.hpp"
#include "units/loop_bound.hpp"
#include "units/magnitude.hpp"
#include "units/quantity.hpp"

namespace motion {

// Half the square of a speed, in nm um/s^2: the work of an acceleration (um/s^2) over a distance
// (nm) is simply added. Speeds are kept in this form as long as possible.
using SpecificEnergy =
    units::Quantity<struct NanometerMicrometerPerSecondSquaredUnit, std::uint64_t>;

// speed <= max_speed
constexpr SpecificEnergy energy_of(units::MicrometersPerSecond speed) {
  const auto count = static_cast<std::uint64_t>(speed.count());
  return SpecificEnergy(count * count * 500);
}

// Displacement of each axis per length of path, in 2^-24.
using Direction = units::PerAxis<std::int32_t>;
inline constexpr int direction_fraction_bits = 24;

// A line is not so slow that a tick takes longer: the step generator keeps a rate of 0.1 ticks/s.
inline constexpr units::Microseconds longest_tick{9'000'000};

// The limits of the hardware that makes the steps.
struct StepTiming {
  units::Hertz clock{};
  units::PerAxis<units::Hertz> max_step_rate{};  // by the drivers' pulse timing
  units::Microseconds least_line_time{};  // lines that are shorter come faster than it can be fed
  units::Microseconds longest_pass{40'000};  // between two looks at whether it needs segments
};

// In 56 bytes, since the planner keeps many.
struct Line {
  units::PerAxis<std::int32_t> steps{};
  std::uint8_t stop_mask{};  // end stops that end all motion
  LineStart start{};
  std::int8_t rate_exponent{};  // -120 .. -30, and mantissa: see rate_of_root
  std::uint32_t rate_mantissa{};
  SpecificEnergy work{};  // of the mean acceleration of a ramp over the whole length
  SpecificEnergy max_entry{};  // energies of the highest speed allowed at the start,
  SpecificEnergy entry{};  // and of the planned one
  units::MicrometersPerSecond speed{};  // requested, under the limits
  std::uint32_t least_time_us{};  // at this speed; what is longer than 71 minutes counts as that

  // The largest |steps|.
  std::uint32_t ticks() const {
    std::uint32_t most = 0;
    units::LoopBound<units::axis_count> axes;
    for (const std::int32_t count : steps) {
      axes.next();
      most = std::max(most, units::magnitude(count));
    }
    return most;
  }
  // Tick rate in ticks per clock = this * sqrt(energy).
  Scaled rate_of_root() const { return Scaled::of_parts(rate_mantissa, rate_exponent); }
  SpecificEnergy nominal() const { return energy_of(speed); }
  units::Microseconds least_time() const { return units::Microseconds(least_time_us); }
};
static_assert(sizeof(Line) == 56);

// A displacement as the G-code requests it, and in the steps that realise it.
struct Displacement {
  units::PerAxis<units::Nanometers> distance{};  // not 0 where there are steps
  units::PerAxis<std::int32_t> steps{};
  units::PerAxis<StepParts> residual{};  // of the position at the start plus that at the end
};

// The properties of a line on which its junctions depend.
struct Course {
  std::uint32_t ticks{};
  Direction direction{};
  units::MicrometersPerSecond speed{};  // nominal
  units::MicrometersPerSecondSquared acceleration{};
  SpecificEnergy work{};  // of the acceleration over the whole length
  bool extruder_leads{};
};

// Makes lines from displacements under the limits of the axes and of the step generator.
class Geometry {
 public:
  [[gnu::cold]] Geometry(const Limits& limits, const StepTiming& timing);

  const Limits& limits() const { return limits_; }
  units::Hertz clock() const { return clock_; }

  // Writes all of `line` but the energies at its ends, its start and its stop mask. Not all steps
  // are 0; feedrate 1 .. max_speed. Distances keep the course and the speed true where steps are
  // coarse; the pulse rate of no axis exceeds what its maximum speed and its driver allow. A line
  // that would last less than `least_time` is slower, one with ticks beyond longest_tick faster.
  Course make_line(const Displacement& displacement, units::MicrometersPerSecond feedrate,
                   units::Microseconds least_time, Line& line) const;

 private:
  struct Path {
    Scaled length;  // nm, of X, Y and Z, or of E where that leads
    Scaled inverse;  // of the length
    bool extruder_leads;
    Direction direction;
    units::MicrometersPerSecond feedrate;
    units::MicrometersPerSecondSquared acceleration;
  };
  Path path_of(const Displacement& displacement, units::MicrometersPerSecond feedrate) const;
  Scaled time_of_steps(const Displacement& displacement) const;
  Scaled length_of_few_steps(const Line& line, const Path& path) const;
  units::MicrometersPerSecondSquared limited_acceleration(const Path& path,
                                                          Scaled ticks_per_length) const;

  Limits limits_;
  units::Hertz clock_;
  units::PerAxis<Scaled> time_per_step_{};  // at the highest rate, ms
  int longest_exponent_{};  // of these
  units::PerAxis<Scaled> length_per_step_{};  // nm
  Scaled rate_factor_{};  // ticks per clock of 1 tick/nm at an energy of 1
  Scaled max_tick_acceleration_{};  // um/s^2 at 1 tick/nm that the segment's format can hold
};

}  // namespace motion
