// SPDX-License-Identifier: Apache-2.0
// The play in steps.
#include "motion/backlash.hpp"

#include "motion/steps.hpp"

namespace motion {

void Backlash::configure(const BacklashSettings& settings, const Limits& limits) {
  settings_ = settings;
  set_limits(limits);
}

void Backlash::set_limits(const Limits& limits) {
  for (std::size_t i = 0; i < BacklashSettings::axes; ++i) {
    const units::Nanometers taken_up(settings_.lengths[i].count() *
                                     std::int64_t{settings_.correction} /
                                     std::int64_t{BacklashSettings::whole});
    steps_[i] = static_cast<std::int32_t>(
        steps_at(units::Position(taken_up), limits.axes[i].steps_per_meter).steps);
    lengths_[i] = position_of(steps_[i], limits.axes[i].steps_per_meter);
  }
}

}  // namespace motion
