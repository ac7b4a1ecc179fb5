// SPDX-License-Identifier: Apache-2.0
// Drives planner and shaping as the firmware does, with a second planner whose segments
// say in exact arithmetic where each axis is to be.
#pragma once

#include <cstdint>
#include <vector>

#include "motion/planner.hpp"
#include "motion/shaping.hpp"

namespace motion_test {

struct ShapingRunResult {
  units::PerAxis<std::int64_t> steps{};  // in all
  std::uint64_t slots{};
  std::uint64_t motions{};  // from rest to rest
  double seconds{};  // of all slots
  double planned_seconds{};  // of the planner's segments
  double worst_distance_steps{};  // of any axis, at the end of any slot, from the exact convolution
  double worst_rate{};  // of any axis in any slot, as a part of what its driver takes
  std::uint64_t wrong_slots{};  // not 2^n clocks, or of a form that the generator refuses
  std::uint64_t wrong_ends{};  // ends of a motion at another place than the planner's
  std::uint64_t turns{};  // of E within a motion
};

struct ShapingRunOptions {
  motion::Limits limits{};
  motion::StepTiming timing{};
  motion::ShapingSettings settings{};
  bool against_exact{true};  // without rests between the moves
  // Moves come while those before are executed, after so many slots each; 0: as many as fit.
  std::uint32_t slots_per_move{};
};

// All moves from position 0.
ShapingRunResult run_shaping(const ShapingRunOptions& options,
                             const std::vector<motion::LineMove>& moves);

}  // namespace motion_test
