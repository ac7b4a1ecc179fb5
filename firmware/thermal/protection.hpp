// SPDX-License-Identifier: Apache-2.0
// Checks that a heater and its sensor belong together: a heated block must get hot and stay so.
#pragma once

#include <optional>

#include "thermal/fault.hpp"
#include "units/quantity.hpp"

namespace thermal {

// The defaults are Marlin's for a hotend (WATCH_TEMP_*, THERMAL_PROTECTION_*).
struct ProtectionSettings {
  units::Millicelsius watch_rise{2'000};  // while heating up it must rise so much
  units::Milliseconds watch_period{20'000};  // within this time
  units::Millicelsius runaway_drop{4'000};  // once reached it may be so much colder
  units::Milliseconds runaway_period{40'000};  // for this long
};

class Protection {
 public:
  explicit constexpr Protection(const ProtectionSettings& settings) : settings_(settings) {}

  // The target has changed.
  void restart();
  // The heater pauses: the time for the rise begins again after it.
  void pause() {
    if (phase_ == Phase::heating) phase_ = Phase::off;
  }
  // The target has been reached since it was set.
  bool holding() const { return phase_ == Phase::holding; }
  // Target 0 is off.
  std::optional<Fault> update(units::Millicelsius target, units::Millicelsius measured,
                              units::Milliseconds now);

 private:
  enum class Phase : std::uint8_t { off, heating, holding };

  std::optional<Fault> watch_heating(units::Millicelsius target, units::Millicelsius measured,
                                     units::Milliseconds now);
  std::optional<Fault> watch_holding(units::Millicelsius target, units::Millicelsius measured,
                                     units::Milliseconds now);

  ProtectionSettings settings_;
  Phase phase_ = Phase::off;
  units::Millicelsius rise_goal_{};
  units::Milliseconds rise_deadline_{};
  units::Milliseconds last_held_{};
};

}  // namespace thermal
