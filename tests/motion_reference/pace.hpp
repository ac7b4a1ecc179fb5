// SPDX-License-Identifier: Apache-2.0
// Reference: how many base clocks the common base does in each clock, under override,
// hold and brake.
#pragma once

#include <cstdint>

namespace motion_reference {

// Scales and slopes in 2^-32, as in the registers override_slope and brake_slope.
class Pace {
 public:
  static constexpr std::uint64_t one = std::uint64_t{1} << 32u;

  std::uint64_t target = one, slope = 1718, brake_slope = 1718;

  // Base clocks of the current clock: 0, 1, 2 or 4.
  std::uint64_t leap() const { return leap_; }
  std::uint64_t scale() const { return scale_; }
  // No base clock was executed in the clock before.
  bool standing() const { return standing_; }

  // To the next clock. `moving`, `braking`, `stalled`: in the current one; `acceleration`: in the
  // one before, only its sign counts; `rate`: the tick rate in 2^-64 ticks per clock by which the
  // next leap is judged.
  void clock(bool moving, bool braking, bool stalled, std::int64_t acceleration,
             std::uint64_t rate);

 private:
  void share_out(bool moving, std::uint64_t rate);
  // The slope, or what is left of it where the acceleration of the base is to the same side.
  std::uint64_t permitted_slope(std::int64_t acceleration) const;
  void approach(std::uint64_t goal, std::uint64_t change);

  std::uint64_t scale_ = one;
  std::uint64_t owed_ = 0;
  std::uint64_t leap_ = 0;
  bool standing_ = false;
};

}  // namespace motion_reference
