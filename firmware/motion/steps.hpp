// SPDX-License-Identifier: Apache-2.0
// Exact conversion between positions in nanometres and in motor steps.
#pragma once

#include <cstdint>
#include <expected>

#include "motion/fault.hpp"
#include "units/quantity.hpp"

namespace motion {

// Positions beyond this (1000 km of filament) are refused.
inline constexpr units::Nanometers max_position{1'000'000'000'000'000};

// position * steps_per_meter / 10^9, rounded to the nearest step, halves away from 0, without
// error. |position| <= max_position, steps_per_meter <= max_steps_per_meter.
std::int64_t steps_at(units::Nanometers position, units::StepsPerMeter steps_per_meter);

// The position of a step count, rounded to the nearest nanometre, halves away from 0.
units::Nanometers position_of(std::int64_t steps, units::StepsPerMeter steps_per_meter);

}  // namespace motion
