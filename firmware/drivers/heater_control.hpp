// SPDX-License-Identifier: Apache-2.0
// The heater gates: duties, the watchdog that must be fed, limits that lock, and what has tripped.
#pragma once

#include <cstddef>
#include <cstdint>

#include "thermal/sensor_reading.hpp"
#include "units/quantity.hpp"

namespace drivers {

struct HeaterStatus {
  bool gate{};  // open now
  bool permitted{};  // nothing forbids to heat
  bool limits_locked{};
  bool tripped{};  // one of the following is latched
  bool watchdog_trip{};
  bool sensor_invalid_trip{};
  bool sensor_stale_trip{};
  bool too_hot_trip{};
  bool too_cold_trip{};
  bool limits_missing_trip{};
  bool emergency_stop_trip{};
};

class HeaterControl {
 public:
  explicit constexpr HeaterControl(units::Hertz clock) : clock_(clock) {}

  // The hardware cuts both to its own maximum of about 3 s.
  void set_timeouts(units::Milliseconds watchdog, units::Milliseconds sensor);
  // Shortest time that a modulated gate keeps its level.
  void set_slot(units::Microseconds slot);
  // For good: a second call changes nothing until reset. Without limits no gate opens.
  void lock_limits(std::size_t channel, const thermal::CountLimits& limits);

  // The software is alive; to be called more often than the watchdog's time-out.
  void feed();
  // Of 65535. Feed the watchdog first: a duty that is not allowed trips the channel.
  void set_duty(std::size_t channel, std::uint16_t duty);
  HeaterStatus status(std::size_t channel) const;
  // Sets the duty to 0 and forgets what has tripped; what still holds trips again with the next
  // duty.
  void clear_trips(std::size_t channel);

 private:
  units::Hertz clock_;
};

}  // namespace drivers
