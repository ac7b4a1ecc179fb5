// SPDX-License-Identifier: Apache-2.0
// Where the steps of X and Y begin in a line, so that the path stays near the exact one.
#pragma once

#include <cstdint>

#include "motion/segment.hpp"
#include "motion/steps.hpp"
#include "units/axes.hpp"

namespace motion {

// A line runs between positions that are rounded to steps, so it may lie off the exact line all
// along, and the steps off that by half a step more. Where the rounding at both ends together
// moves it by more than a quarter of a step, an axis begins a quarter of a step earlier or later.
// That is best done across the path: where X or Y steps at every tick, the other one is shifted.
// `residual`: exact less rounded position at the start plus that at the end of the line. `ticks`:
// the largest |steps|. Only X and Y are shifted.
LineStart line_start(const units::PerAxis<std::int32_t>& steps, std::uint32_t ticks,
                     const units::PerAxis<StepParts>& residual);

}  // namespace motion
