// SPDX-License-Identifier: Apache-2.0
// A command of the step generator: a part of a straight line with one course of the tick rate.
#pragma once

#include <cstdint>

#include "units/axes.hpp"

namespace motion {

// Axes whose steps come a quarter of a step early or late in a line, never both: their Bresenham
// error terms start at 3/4 or 1/4 of line_ticks, those of the others at 1/2.
struct LineStart {
  units::AxisSet ahead, behind;
};

// A line with |steps| per axis is walked in `line_ticks` base ticks (line_ticks >= every |steps|,
// normally equal to the largest). It is cut into segments of `ticks` base ticks each, one for each
// phase of its speed profile; all segments of a line carry the same steps, start and line_ticks,
// and every one but the first sets `continues_line`, so that the Bresenham error terms run on and
// the line stays straight to the step. After line_ticks ticks in all, every axis has made exactly
// its steps.
struct Segment {
  units::PerAxis<std::int32_t> steps{};  // signed, of the whole line
  LineStart start{};
  std::uint32_t line_ticks{};  // 1 .. 2^31 - 1
  std::uint32_t ticks{};  // 1 .. line_ticks
  bool continues_line{};
  bool ends_motion{};  // standing still after this segment is intended: an empty queue is no
      // underrun
  // Course of the base tick rate. Each clock: phase += rate; rate += acceleration; acceleration +=
  // jerk. A tick is made when the phase passes 1. The rate never exceeds 1/2 tick per clock and is
  // never integrated below the step generator's rate floor.
  std::uint64_t rate{};  // initial, ticks per clock, 2^-64 each
  std::int64_t acceleration{};  // initial, ticks per clock^2, 2^-84 each
  std::int64_t jerk{};  // ticks per clock^3, 2^-84 each
  std::uint8_t stop_mask{};  // end stops (bit = input) that end all motion when triggered,
  bool stop_on_change{};  // only if they become so during this segment,
  bool stop_on_release{};  // or when released instead,
  bool stop_brakes{};  // along the step generator's brake slope instead of at once
  bool waits_for_start{};  // begins from rest, and only at the start input or software's start
};

}  // namespace motion
