// SPDX-License-Identifier: Apache-2.0
// Compares how far rounding has moved a line with a quarter of a step, without a division.
#include "motion/line_start.hpp"

namespace motion {

namespace {

constexpr std::int32_t quarter_step = one_step.count() / 4;

// An axis in its own direction; |steps| < 2^31.
struct Forward {
  std::int32_t steps, residual;
};

Forward forward(std::int32_t steps, StepParts residual) {
  if (steps < 0) return {.steps = -steps, .residual = -residual.count()};
  return {.steps = steps, .residual = residual.count()};
}

}  // namespace

LineStart line_start(const units::PerAxis<std::int32_t>& steps, std::uint32_t ticks,
                     const units::PerAxis<StepParts>& residual) {
  const std::array<Forward, 2> axes{forward(steps[0], residual[0]), forward(steps[1], residual[1])};
  const std::size_t leader = axes[1].steps > axes[0].steps ? 1 : 0;
  const bool leads = static_cast<std::uint32_t>(axes[leader].steps) == ticks;
  const Forward reference = leads ? axes[leader] : Forward{.steps = 1, .residual = 0};
  LineStart start;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const Forward& axis = axes[i];
    if (axis.steps == 0 || (leads && i == leader)) continue;
    // Where the reference is right, the axis is off by its own residual less its share of the
    // reference's; all of this times the reference's steps.
    const std::int64_t share = std::int64_t{reference.residual} * axis.steps;
    const std::int64_t above = std::int64_t{axis.residual - quarter_step} * reference.steps;
    const std::int64_t below = std::int64_t{axis.residual + quarter_step} * reference.steps;
    if (above > share) start.ahead.insert(static_cast<units::Axis>(i));
    if (below < share) start.behind.insert(static_cast<units::Axis>(i));
  }
  return start;
}

}  // namespace motion
