// SPDX-License-Identifier: Apache-2.0
// Exact conversion between positions in nanometres and in motor steps.
#pragma once

#include <cstdint>
#include <expected>

#include "motion/fault.hpp"
#include "units/axes.hpp"
#include "units/loop_bound.hpp"
#include "units/position.hpp"
#include "units/quantity.hpp"

namespace motion {

// Positions beyond this (1000 km of filament) are refused.
inline constexpr units::Nanometers max_position{1'000'000'000'000'000};

inline bool is_in_range(const units::Position& position) {
  return position >= -max_position && position <= max_position;
}

// All of them.
inline bool are_in_range(const units::PerAxis<units::Position>& positions) {
  // Nearly all are decided by the upper words: smaller than `sure` in magnitude.
  constexpr auto sure = static_cast<std::uint32_t>(max_position.count() >> 32);
  std::uint32_t largest = 0;
  for (const units::Position& position : positions) {
    const auto upper = static_cast<std::int32_t>(position.whole().count() >> 32);
    largest |= static_cast<std::uint32_t>(upper ^ upper >> 31);
  }
  if (largest < sure) return true;
  units::LoopBound<units::axis_count> axes;
  for (const units::Position& position : positions) {
    axes.next();
    if (!is_in_range(position)) return false;
  }
  return true;
}

// Parts of a step, 1 953 125 of which are one (10^9 / 2^9: what the division leaves).
using StepParts = units::Quantity<struct StepPartUnit, std::int32_t>;
inline constexpr StepParts one_step{1'953'125};

// The steps at a position, and what is left of it: position less steps, -1/2 .. 1/2 step.
struct StepPosition {
  std::int64_t steps{};
  StepParts residual{};
};

// position in nm * steps_per_meter / 10^9, rounded to the nearest step, halves away from 0,
// without error; the residual is rounded to a part. |position| <= max_position,
// steps_per_meter <= max_steps_per_meter.
StepPosition steps_at(const units::Position& position, units::StepsPerMeter steps_per_meter);

// The position of a step count, rounded to the nearest nanometre, halves away from 0.
units::Nanometers position_of(std::int64_t steps, units::StepsPerMeter steps_per_meter);

}  // namespace motion
