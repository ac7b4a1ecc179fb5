// SPDX-License-Identifier: Apache-2.0
// Detects that a temperature has reached its target and stays there, for M109 and M190 as
// in Marlin.
#pragma once

#include <optional>

#include "units/quantity.hpp"

namespace thermal {

struct ArrivalSettings {
  units::Millicelsius window{1'000};  // the residency begins within this of the target
  units::Millicelsius hysteresis{3'000};  // and starts over beyond this
  units::Milliseconds residency{5'000};
};

class Arrival {
 public:
  explicit constexpr Arrival(const ArrivalSettings& settings) : settings_(settings) {}

  void restart();
  void update(units::Millicelsius target, units::Millicelsius measured, units::Milliseconds now);
  bool arrived() const { return arrived_; }
  // Until it has arrived if all stays well; nothing while the residency has not begun.
  std::optional<units::Milliseconds> time_left(units::Milliseconds now) const;

 private:
  ArrivalSettings settings_;
  std::optional<units::Milliseconds> within_since_;
  bool arrived_ = false;
};

}  // namespace thermal
