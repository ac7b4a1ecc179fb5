// SPDX-License-Identifier: Apache-2.0
// Where the axes are at any time within a segment: what the step generator does with it, as a
// function of time.
#pragma once

#include <cstdint>

#include "motion/segment.hpp"
#include "units/axes.hpp"

namespace motion {

// Positions are counted in 2^-8 step, modulo 2^32.
inline constexpr int position_fraction_bits = 8;
using FinePosition = std::uint32_t;

// Follows the segments of lines one after another. Rates end where the formula of uniform
// acceleration has them, so that each segment ends exactly at its last tick; in between a position
// is off by less than 2^-28 of the line.
class Timeline {
 public:
  // The segment after the one before, all of which is over. Jerk is 0.
  void begin(const Segment& segment);
  // Forgets the segment, and begins at position 0 of all axes.
  void clear() { *this = {}; }

  std::uint64_t clocks() const { return clocks_; }  // that the segment lasts, at least 1
  bool prints() const { return prints_; }

  // After `elapsed` clocks of the segment, at most clocks().
  units::PerAxis<FinePosition> at(std::uint64_t elapsed) const;
  // At its end.
  units::PerAxis<FinePosition> end() const;

 private:
  void begin_line(const Segment& segment);
  void set_time(const Segment& segment);
  units::PerAxis<FinePosition> after(std::uint64_t ticks_31) const;

  // Of the line.
  units::PerAxis<FinePosition> start_{};
  units::PerAxis<std::int32_t> steps_{};
  units::PerAxis<std::uint32_t> part_{};  // of a tick that an axis moves, in 2^-31 step
  std::uint32_t line_ticks_{};
  bool prints_{};  // E forwards along X or Y

  // Of the segment.
  std::uint32_t ticks_before_{};  // of the line
  std::uint32_t ticks_{};
  std::uint64_t clocks_{};
  std::uint32_t inverse_{};  // 2^(31 + bits) / clocks
  std::uint8_t bits_{};  // of clocks
  std::uint32_t first_rate_{};  // in 2^-30 of the mean one
};

}  // namespace motion
