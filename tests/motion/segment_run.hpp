// SPDX-License-Identifier: Apache-2.0
// A planner whose segments are looked at as they are handed over, without executing them clock by
// clock: fast enough for many thousand random prints.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "motion/planner.hpp"
#include "motion/segment.hpp"

namespace motion_test {

struct SegmentRunResult {
  double seconds{};  // of all segments
  std::vector<double> speeds{};  // in ticks/s, at the start of each line
  std::vector<motion::Segment> lines{};  // the first segment of each
  units::PerAxis<std::int64_t> steps{};
  std::uint64_t third_order{};  // segments with a jerk
  // Excesses over what is allowed, as parts of it; 0 or less where kept. Rounding may give a line a
  // step more than its distance has: what that makes is allowed.
  double worst_speed{-1}, worst_acceleration{-1}, worst_jump{-1};
};

// How long it lasts by its numbers.
double seconds_of(const motion::Segment& segment, double clock_hz);

// Hands over all moves; the planner holds at most `look_ahead` lines at a time.
SegmentRunResult run_segments(const motion::Limits& limits,
                              const std::vector<motion::LineMove>& moves, std::uint32_t clock_hz,
                              std::size_t look_ahead = motion::Planner::capacity);

}  // namespace motion_test
