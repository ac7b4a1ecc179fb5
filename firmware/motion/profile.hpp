// SPDX-License-Identifier: Apache-2.0
// The course of a line's tick rate: up to three phases (accelerate, cruise, brake) in whole ticks.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "motion/line.hpp"
#include "units/quantity.hpp"

namespace motion {

struct Phase {
  std::uint32_t ticks{};
  // Of a ramp of third order (s_curve): `rate` is the first one, and `acceleration` the change to
  // the last one in 2^-64 ticks per clock. 0: the phase is one segment.
  std::uint32_t apex{};
  std::uint64_t rate{};  // as in Segment
  std::int64_t acceleration{};  // as in Segment
};
static_assert(sizeof(Phase) == 24);

// Acceleration, cruise, braking.
inline constexpr std::size_t most_phases = 3;

struct Profile {
  std::array<Phase, most_phases> phases{};
  std::size_t count{};
  std::uint32_t ticks{};  // of all
  units::Microseconds time{};
};

// The phases of a line from its planned entry to `exit`, which must be reachable: |exit - entry|
// <= work.
//
// The ticks of the phases sum up to line.ticks. Phases begin and end with energies that differ by
// no more than the line's work over their ticks, so the acceleration is never exceeded; the rate
// with which one phase ends and that with which the next begins are the same but for 2^-29 and for
// the one clock in which the hardware changes phase. The hardware adds before it integrates, so
// after T clocks its phase is rate T + acceleration T (T - 1) / 2; starting with half an
// acceleration more makes that the exact parabola. No rate is less than that in the middle of the
// first tick from rest, sqrt(acceleration), unless the nominal one is.
//
// Where the nominal speed is not reached, at least `min_cruise_percent` of what is left for ramps
// is cruised: short lines to and fro do not shake the machine (Klipper's minimum_cruise_ratio).
//
// With `s_curve` ramps are of third order where they are long enough for it.
void make_profile(const Line& line, SpecificEnergy exit, units::Hertz clock,
                  std::uint8_t min_cruise_percent, bool s_curve, Profile& profile);

inline Profile profile_of(const Line& line, SpecificEnergy exit, units::Hertz clock,
                          std::uint8_t min_cruise_percent = 0, bool s_curve = false) {
  Profile profile;
  make_profile(line, exit, clock, min_cruise_percent, s_curve, profile);
  return profile;
}

}  // namespace motion
