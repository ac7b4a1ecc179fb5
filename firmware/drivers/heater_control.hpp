// SPDX-License-Identifier: Apache-2.0
// The heater gates and their supply: duties, the watchdog that must be fed, limits that lock, what
// has tripped.
#pragma once

#include <cstddef>
#include <cstdint>

#include "registers/heater_control_registers.hpp"
#include "thermal/sensor_reading.hpp"
#include "units/quantity.hpp"

namespace drivers {

struct HeaterStatus {
  bool gate{};  // open now
  bool permitted{};  // nothing forbids to heat
  bool limits_locked{};  // all four
  bool refused{};  // a write to a limit: it was locked, or the value out of the hardware's bounds
  bool tripped{};  // one of the following is latched
  bool watchdog_trip{};
  bool sensor_invalid_trip{};
  bool sensor_stale_trip{};
  bool too_hot_trip{};
  bool too_cold_trip{};
  bool limits_missing_trip{};
  bool emergency_stop_trip{};
  bool heats_unasked_trip{};
};

// What is written once for each channel.
struct HeaterLimits {
  thermal::CountLimits counts;
  std::uint32_t hot{};  // count below which heat that is not requested is a trip
  units::Milliseconds settle{};  // how long a gate must be closed before rising heat is not its own
};

// The power of all heaters.
struct SupplyStatus {
  bool closed{};
  bool refused{};  // the last request to close it
  // What has opened it since it was closed last.
  bool trip_opened{};
  bool watchdog_opened{};
  bool emergency_stop_opened{};
  bool veto_opened{};
};

// The watchdog needs both in turn, from two places of the program that must both run.
using FeedKey = registers::heater_control::Feed::Key;

class HeaterControl {
 public:
  explicit constexpr HeaterControl(units::Hertz clock) : clock_(clock) {}

  // The hardware cuts both to its own maximum of about 3 s.
  void set_timeouts(units::Milliseconds watchdog, units::Milliseconds sensor);
  // Shortest time that a modulated gate keeps its level.
  void set_slot(units::Microseconds slot);
  // For good: a second call changes nothing until reset. Without limits no gate opens. Locks the
  // settings of the temperature converter too. False where they do not read back as written, within
  // 3 %.
  [[nodiscard]] bool lock_limits(std::size_t channel, const HeaterLimits& limits);

  // The software is alive. `first` at least a sixteenth of the watchdog's time-out after the last
  // `first`, `second` once after each `first`; anything else trips all channels. What counts as
  // fed is the second.
  void feed(FeedKey key);

  // Closes the supply; refused unless all duties are 0, the watchdog is fed and nothing
  // has tripped.
  void close_supply();
  void open_supply();
  SupplyStatus supply() const;

  // Of 65535. Feed the watchdog first: a duty that is not allowed trips the channel.
  void set_duty(std::size_t channel, std::uint16_t duty);
  HeaterStatus status(std::size_t channel) const;
  // Sets the duty to 0 and clears the trips; a cause that persists trips again with the next duty.
  void clear_trips(std::size_t channel);

 private:
  units::Hertz clock_;
};

}  // namespace drivers
