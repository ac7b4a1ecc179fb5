// SPDX-License-Identifier: Apache-2.0
// The heater gates and their supply: duties, the watchdog that must be fed, limits that lock, what
// has tripped.
#include "drivers/heater_control.hpp"

#include <algorithm>

#include "platform/bus.hpp"
#include "registers/heater_control_registers.hpp"

namespace drivers {
namespace {

namespace registers = ::registers::heater_control;

constexpr std::int64_t cycles_per_tick = registers::tick_cycles;

// Rounded down, so that a time-out is never longer than requested; at most what the register holds.
std::uint32_t ticks_of(units::Milliseconds time, units::Hertz clock, std::int64_t most) {
  const std::int64_t ticks = time.count() * clock.count() / (1'000 * cycles_per_tick);
  return static_cast<std::uint32_t>(std::clamp<std::int64_t>(ticks, 0, most));
}

// The value in the hardware is accepted within this: a program loaded over another one finds its
// limits, which were measured slightly differently.
bool lock(std::uint32_t address, std::uint32_t value) {
  constexpr int tolerance_shift = 5;
  platform::bus_write(address, value);
  const std::uint32_t found = platform::bus_read(address);
  return (found > value ? found - value : value - found) <= value >> tolerance_shift;
}

}  // namespace

void HeaterControl::set_timeouts(units::Milliseconds watchdog, units::Milliseconds sensor) {
  platform::write(
      registers::Watchdog{.ticks = ticks_of(watchdog, clock_, registers::Watchdog::ticks_max)});
  platform::write(registers::SensorTimeout{
      .ticks = ticks_of(sensor, clock_, registers::SensorTimeout::ticks_max)});
}

void HeaterControl::set_slot(units::Microseconds slot) {
  const std::int64_t cycles = slot.count() * clock_.count() / 1'000'000;
  platform::write(registers::Slot{.cycles = static_cast<std::uint32_t>(std::clamp<std::int64_t>(
                                      cycles, 1, registers::Slot::cycles_max))});
}

bool HeaterControl::lock_limits(std::size_t channel, const HeaterLimits& limits) {
  // All are written, even if one is refused: each locked limit protects.
  const bool minimum = lock(registers::MinimumCount::address_of(channel), limits.counts.minimum);
  const bool maximum = lock(registers::MaximumCount::address_of(channel), limits.counts.maximum);
  const bool hot = lock(registers::HotCount::address_of(channel), limits.hot);
  const bool settle = lock(registers::Settle::address_of(channel),
                           ticks_of(limits.settle, clock_, registers::Settle::ticks_max));
  return minimum && maximum && hot && settle;
}

void HeaterControl::feed(FeedKey key) { platform::write(registers::Feed{.key = key}); }

void HeaterControl::close_supply() {
  platform::write(registers::Supply{.key = registers::Supply::Key::close});
}

void HeaterControl::open_supply() {
  platform::write(registers::Supply{.key = registers::Supply::Key::open});
}

SupplyStatus HeaterControl::supply() const {
  const auto supply = platform::read<registers::Supply>();
  return {.closed = supply.closed,
          .refused = supply.refused,
          .trip_opened = supply.trip_opened,
          .watchdog_opened = supply.watchdog_opened,
          .emergency_stop_opened = supply.emergency_stop_opened,
          .veto_opened = supply.veto_opened};
}

void HeaterControl::set_duty(std::size_t channel, std::uint16_t duty) {
  platform::write(channel, registers::Duty{.density = duty});
}

HeaterStatus HeaterControl::status(std::size_t channel) const {
  const auto status = platform::read<registers::Status>(channel);
  return {.gate = status.gate,
          .permitted = status.permitted,
          .limits_locked = status.minimum_locked && status.maximum_locked && status.hot_locked &&
                           status.settle_locked,
          .refused = status.refused,
          .tripped = status.tripped,
          .watchdog_trip = status.watchdog_trip,
          .sensor_invalid_trip = status.sensor_invalid_trip,
          .sensor_stale_trip = status.sensor_stale_trip,
          .too_hot_trip = status.too_hot_trip,
          .too_cold_trip = status.too_cold_trip,
          .limits_missing_trip = status.limits_missing_trip,
          .emergency_stop_trip = status.emergency_stop_trip,
          .heats_unasked_trip = status.heats_unasked_trip};
}

void HeaterControl::clear_trips(std::size_t channel) {
  set_duty(channel, 0);
  platform::write(registers::Clear{.channels = std::uint32_t{1} << channel,
                                   .key = registers::Clear::Key::clear_trips});
}

}  // namespace drivers
