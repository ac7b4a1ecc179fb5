// SPDX-License-Identifier: Apache-2.0
// Detects that a temperature has reached its target and stays there, for M109 and M190 as
// in Marlin.
#include "thermal/arrival.hpp"

namespace thermal {

void Arrival::restart() {
  within_since_.reset();
  arrived_ = false;
}

void Arrival::update(units::Millicelsius target, units::Millicelsius measured,
                     units::Milliseconds now) {
  if (arrived_) return;
  const units::Millicelsius difference = measured > target ? measured - target : target - measured;
  if (!within_since_ && difference <= settings_.window) within_since_ = now;
  if (difference > settings_.hysteresis) within_since_.reset();
  if (within_since_ && now - *within_since_ >= settings_.residency) arrived_ = true;
}

std::optional<units::Milliseconds> Arrival::time_left(units::Milliseconds now) const {
  if (arrived_) return units::Milliseconds(0);
  if (!within_since_) return std::nullopt;
  const units::Milliseconds left = settings_.residency - (now - *within_since_);
  return left > units::Milliseconds(0) ? left : units::Milliseconds(0);
}

}  // namespace thermal
