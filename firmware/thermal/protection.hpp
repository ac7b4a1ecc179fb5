// SPDX-License-Identifier: Apache-2.0
// Watches that a heater and its sensor belong together: what heats must get hot, what is off must
// not.
#pragma once

#include <optional>

#include "thermal/controller.hpp"
#include "thermal/fault.hpp"
#include "units/quantity.hpp"

namespace thermal {

// The defaults are Marlin's for a hotend (WATCH_TEMP_*, THERMAL_PROTECTION_*).
struct ProtectionSettings {
  units::Millicelsius watch_rise{2'000};  // while heating up it must rise so much
  units::Milliseconds watch_period{20'000};  // within this time
  units::Millicelsius runaway_drop{4'000};  // once reached it may be so much colder
  units::Milliseconds runaway_period{40'000};  // for this long
  units::Millicelsius unasked_rise{8'000};  // with the heater off it may rise so much
  units::Milliseconds unasked_period{60'000};  // within this time
  units::Milliseconds unasked_settle{10'000};  // after the heat that was still on its way
};

class Protection {
 public:
  explicit constexpr Protection(const ProtectionSettings& settings) : settings_(settings) {}

  // The target has changed.
  void restart();
  // Target 0 is off. `duty` is what the heater was given since the last update.
  std::optional<Fault> update(units::Millicelsius target, units::Millicelsius measured, Duty duty,
                              units::Milliseconds now);

 private:
  enum class Phase : std::uint8_t { off, heating, holding };

  std::optional<Fault> watch_heating(units::Millicelsius target, units::Millicelsius measured,
                                     units::Milliseconds now);
  std::optional<Fault> watch_holding(units::Millicelsius target, units::Millicelsius measured,
                                     units::Milliseconds now);
  std::optional<Fault> watch_unasked_heat(units::Millicelsius measured, Duty duty,
                                          units::Milliseconds now);

  ProtectionSettings settings_;
  Phase phase_ = Phase::off;
  units::Millicelsius rise_goal_{};
  units::Milliseconds rise_deadline_{};
  units::Milliseconds last_held_{};
  std::optional<units::Milliseconds> idle_since_;  // and nothing was wrong until then
  units::Millicelsius coolest_idle_{};
};

}  // namespace thermal
