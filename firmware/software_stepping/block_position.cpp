// SPDX-License-Identifier: Apache-2.0
// Bresenham's line in closed form.
#include "software_stepping/block_position.hpp"

#include "platform/division.hpp"
#include "units/magnitude.hpp"

namespace software_stepping {
namespace {

// Steps of an axis after so many ticks of the line.
std::int32_t steps_after(const Line& line, std::uint32_t ticks, std::size_t axis) {
  const std::uint32_t steps = units::magnitude(line.plain_steps[axis]);
  if (steps == 0) return 0;
  const std::uint64_t sum =
      std::uint64_t{ticks} * steps + first_error(line.plain_ticks, line.start, axis);
  const auto done = static_cast<std::int32_t>(platform::divide(sum, line.plain_ticks));
  return line.plain_steps[axis] < 0 ? -done : done;
}

}  // namespace

std::uint32_t first_error(std::uint32_t ticks, motion::LineStart start, std::size_t axis) {
  const std::uint32_t half = ticks / 2;
  const std::uint32_t quarter = ticks / 4;
  if (start.behind.contains(static_cast<units::Axis>(axis))) return quarter;
  return start.ahead.contains(static_cast<units::Axis>(axis)) ? half + quarter : half;
}

units::PerAxis<std::int32_t> positions_after(const Block& block, std::uint32_t ticks) {
  units::PerAxis<std::int32_t> result = block.line.from;
  for (std::size_t axis = 0; axis < units::axis_count; ++axis) {
    result[axis] += ticks == block.line.plain_ticks ? block.line.plain_steps[axis]
                                                    : steps_after(block.line, ticks, axis);
  }
  return result;
}

}  // namespace software_stepping
