// SPDX-License-Identifier: Apache-2.0
// Where a block takes its axes.
#pragma once

#include <cstdint>

#include "motion/segment.hpp"
#include "software_stepping/block.hpp"
#include "units/axes.hpp"

namespace software_stepping {

// Bresenham's error term with which an axis begins a line (see motion/segment.hpp).
std::uint32_t first_error(std::uint32_t ticks, motion::LineStart start, std::size_t axis);

// After so many ticks of its line.
units::PerAxis<std::int32_t> positions_after(const Block& block, std::uint32_t ticks);

}  // namespace software_stepping
