// SPDX-License-Identifier: Apache-2.0
// Checks that a heater and its sensor belong together: a heated block must get hot and stay so.
#include "thermal/protection.hpp"

namespace thermal {

void Protection::restart() { phase_ = Phase::off; }

std::optional<Fault> Protection::update(units::Millicelsius target, units::Millicelsius measured,
                                        units::Milliseconds now) {
  if (target <= units::Millicelsius(0)) {
    phase_ = Phase::off;
    return std::nullopt;
  }
  switch (phase_) {
    case Phase::off:
      phase_ = Phase::heating;
      rise_goal_ = measured + settings_.watch_rise;
      rise_deadline_ = now + settings_.watch_period;
      return std::nullopt;
    case Phase::heating:
      return watch_heating(target, measured, now);
    case Phase::holding:
      return watch_holding(target, measured, now);
  }
  return std::nullopt;
}

// Each period must bring its rise, up to the band in which holding begins.
std::optional<Fault> Protection::watch_heating(units::Millicelsius target,
                                               units::Millicelsius measured,
                                               units::Milliseconds now) {
  if (measured >= target - settings_.runaway_drop) {
    phase_ = Phase::holding;
    last_held_ = now;
  } else if (measured >= rise_goal_) {
    rise_goal_ = measured + settings_.watch_rise;
    rise_deadline_ = now + settings_.watch_period;
  } else if (now >= rise_deadline_) {
    return Fault::heating_failed;
  }
  return std::nullopt;
}

std::optional<Fault> Protection::watch_holding(units::Millicelsius target,
                                               units::Millicelsius measured,
                                               units::Milliseconds now) {
  if (measured >= target - settings_.runaway_drop) last_held_ = now;
  if (now - last_held_ > settings_.runaway_period) return Fault::thermal_runaway;
  return std::nullopt;
}

}  // namespace thermal
