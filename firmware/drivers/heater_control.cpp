// SPDX-License-Identifier: Apache-2.0
// The heater gates: duties, the watchdog that must be fed, limits that lock, and what has tripped.
#include "drivers/heater_control.hpp"

#include <algorithm>

#include "drivers/registers/heater_control_registers.hpp"
#include "platform/bus.hpp"

namespace drivers {
namespace {

namespace registers = ::registers::heater_control;

constexpr std::int64_t cycles_per_tick = 1024;

// Rounded down, so that a time-out is never longer than asked for; at most what the register holds.
std::uint32_t ticks_of(units::Milliseconds time, units::Hertz clock) {
  const std::int64_t ticks = time.count() * clock.count() / (1'000 * cycles_per_tick);
  return static_cast<std::uint32_t>(std::clamp<std::int64_t>(ticks, 0, 0xF'FFFF));
}

}  // namespace

void HeaterControl::set_timeouts(units::Milliseconds watchdog, units::Milliseconds sensor) {
  platform::write(registers::Watchdog{.ticks = ticks_of(watchdog, clock_)});
  platform::write(registers::SensorTimeout{.ticks = ticks_of(sensor, clock_)});
}

void HeaterControl::set_slot(units::Microseconds slot) {
  const std::int64_t cycles = slot.count() * clock_.count() / 1'000'000;
  platform::write(registers::Slot{
      .cycles = static_cast<std::uint32_t>(std::clamp<std::int64_t>(cycles, 1, 0xFF'FFFF))});
}

void HeaterControl::lock_limits(std::size_t channel, const thermal::CountLimits& limits) {
  platform::write(channel, registers::MinimumCount{.cycles = limits.minimum});
  platform::write(channel, registers::MaximumCount{.cycles = limits.maximum});
}

void HeaterControl::feed() {
  platform::write(registers::Feed{.key = static_cast<std::uint32_t>(registers::Feed::Key::alive)});
}

void HeaterControl::set_duty(std::size_t channel, std::uint16_t duty) {
  platform::write(channel, registers::Duty{.density = duty});
}

HeaterStatus HeaterControl::status(std::size_t channel) const {
  const auto status = platform::read<registers::Status>(channel);
  return {.gate = status.gate,
          .permitted = status.permitted,
          .limits_locked = status.minimum_locked && status.maximum_locked,
          .tripped = status.tripped,
          .watchdog_trip = status.watchdog_trip,
          .sensor_invalid_trip = status.sensor_invalid_trip,
          .sensor_stale_trip = status.sensor_stale_trip,
          .too_hot_trip = status.too_hot_trip,
          .too_cold_trip = status.too_cold_trip,
          .limits_missing_trip = status.limits_missing_trip,
          .emergency_stop_trip = status.emergency_stop_trip};
}

void HeaterControl::clear_trips(std::size_t channel) {
  set_duty(channel, 0);
  platform::write(
      registers::Clear{.channels = std::uint32_t{1} << channel,
                       .key = static_cast<std::uint32_t>(registers::Clear::Key::clear_trips)});
}

}  // namespace drivers
