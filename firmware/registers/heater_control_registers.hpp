// SPDX-License-Identifier: Apache-2.0
// Registers of `heater_control`. Generated from rtl/thermal/heater_control.toml: do not edit.
// clang-format off
#pragma once

#include <cstddef>
#include <cstdint>

// Heater control: gates that open only while watchdog, sensor, limits and emergency stop allow it.
namespace registers::heater_control {

inline constexpr std::uint32_t base = 0xF0006000u;

// Clocks of a tick, the unit of all time-outs and ages of the thermal part.
inline constexpr std::uint32_t tick_cycles = 1024;

// Feeds the watchdog, by two keys in turn. Anything else, the same key again or `first` too early trips all channels.
struct Feed {
  static constexpr std::uint32_t address = base + 0x0u;
  static constexpr unsigned key_low = 0, key_width = 16;
  static constexpr std::uint32_t key_max = 0xFFFFu, key_mask = key_max << key_low;
  enum class Key : std::uint16_t {
    second = 24301,
    first = 65261,
  };
  // `first` not before a sixteenth of the watchdog's time since the last `first`; `second`, which restarts the watchdog, at any time after it.
  Key key{};

  [[gnu::always_inline]] static constexpr Feed decode([[maybe_unused]] std::uint32_t word) {
    return {
      .key = static_cast<Key>((word & 0xFFFFu)),
    };
  }
  constexpr std::uint32_t encode() const {
    return (static_cast<std::uint32_t>(key) & 0xFFFFu);
  }
};

// Time without a complete feed after which all gates close.
struct Watchdog {
  static constexpr std::uint32_t address = base + 0x4u;
  static constexpr unsigned ticks_low = 0, ticks_width = 20;
  static constexpr std::uint32_t ticks_max = 0xFFFFFu, ticks_mask = ticks_max << ticks_low;
  // In ticks of `tick_cycles` clocks, cut to the maximum that is built in; about a second after reset.
  std::uint32_t ticks{};

  [[gnu::always_inline]] static constexpr Watchdog decode([[maybe_unused]] std::uint32_t word) {
    return {
      .ticks = (word & 0xFFFFFu),
    };
  }
  constexpr std::uint32_t encode() const {
    return (ticks & 0xFFFFFu);
  }
};

// Time without a valid conversion after which a channel's gate closes for good.
struct SensorTimeout {
  static constexpr std::uint32_t address = base + 0x8u;
  static constexpr unsigned ticks_low = 0, ticks_width = 20;
  static constexpr std::uint32_t ticks_max = 0xFFFFFu, ticks_mask = ticks_max << ticks_low;
  // In ticks of `tick_cycles` clocks, cut to the maximum that is built in; about a second after reset.
  std::uint32_t ticks{};

  [[gnu::always_inline]] static constexpr SensorTimeout decode([[maybe_unused]] std::uint32_t word) {
    return {
      .ticks = (word & 0xFFFFFu),
    };
  }
  constexpr std::uint32_t encode() const {
    return (ticks & 0xFFFFFu);
  }
};

// Shortest time that a gate keeps its level when it is modulated.
struct Slot {
  static constexpr std::uint32_t address = base + 0xCu;
  static constexpr unsigned cycles_low = 0, cycles_width = 24;
  static constexpr std::uint32_t cycles_max = 0xFFFFFFu, cycles_mask = cycles_max << cycles_low;
  // In clocks; 0 acts as 1.
  std::uint32_t cycles{};

  [[gnu::always_inline]] static constexpr Slot decode([[maybe_unused]] std::uint32_t word) {
    return {
      .cycles = (word & 0xFFFFFFu),
    };
  }
  constexpr std::uint32_t encode() const {
    return (cycles & 0xFFFFFFu);
  }
};

// Clears the trips of channels whose duty is 0, and `refused` of all channels named.
struct Clear {
  static constexpr std::uint32_t address = base + 0x10u;
  static constexpr unsigned channels_low = 0, channels_width = 4;
  static constexpr std::uint32_t channels_max = 0xFu, channels_mask = channels_max << channels_low;
  static constexpr unsigned key_low = 16, key_width = 16;
  static constexpr std::uint32_t key_max = 0xFFFFu, key_mask = key_max << key_low;
  enum class Key : std::uint16_t {
    clear_trips = 49642,
  };
  // One bit per channel.
  std::uint32_t channels{};
  // Must be `clear_trips`; anything else is ignored.
  Key key{};

  [[gnu::always_inline]] static constexpr Clear decode([[maybe_unused]] std::uint32_t word) {
    return {
      .channels = (word & 0xFu),
      .key = static_cast<Key>(((word >> 16u) & 0xFFFFu)),
    };
  }
  constexpr std::uint32_t encode() const {
    return (channels & 0xFu) |
           (static_cast<std::uint32_t>(key) & 0xFFFFu) << 16u;
  }
};

// How much of the time the channel heats. A request: the hardware decides.
struct Duty {
  static constexpr std::size_t count = 4;
  static constexpr std::uint32_t address_of(std::size_t index) {
    return base + 0x14u + 4u * static_cast<std::uint32_t>(index);
  }
  static constexpr unsigned density_low = 0, density_width = 16;
  static constexpr std::uint32_t density_max = 0xFFFFu, density_mask = density_max << density_low;
  // Slots of 65535 in which the gate is open, spread evenly.
  std::uint32_t density{};

  [[gnu::always_inline]] static constexpr Duty decode([[maybe_unused]] std::uint32_t word) {
    return {
      .density = (word & 0xFFFFu),
    };
  }
  constexpr std::uint32_t encode() const {
    return (density & 0xFFFFu);
  }
};

// Smallest thermistor count at which the channel may heat: the cut-off temperature. Locks when written, and the converter's settings with it.
struct MinimumCount {
  static constexpr std::size_t count = 4;
  static constexpr std::uint32_t address_of(std::size_t index) {
    return base + 0x24u + 4u * static_cast<std::uint32_t>(index);
  }
  static constexpr unsigned cycles_low = 0, cycles_width = 32;
  static constexpr std::uint32_t cycles_max = 0xFFFFFFFFu, cycles_mask = cycles_max << cycles_low;
  // Clocks, as the temperature converter counts them; the largest number after reset. Below the built-in floor (4 * 2^-20 s for each charge) a write is refused and locks nothing.
  std::uint32_t cycles{};

  [[gnu::always_inline]] static constexpr MinimumCount decode([[maybe_unused]] std::uint32_t word) {
    return {
      .cycles = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return cycles;
  }
};

// Largest thermistor count at which the channel may heat: too cold or open. Locks when written.
struct MaximumCount {
  static constexpr std::size_t count = 4;
  static constexpr std::uint32_t address_of(std::size_t index) {
    return base + 0x34u + 4u * static_cast<std::uint32_t>(index);
  }
  static constexpr unsigned cycles_low = 0, cycles_width = 32;
  static constexpr std::uint32_t cycles_max = 0xFFFFFFFFu, cycles_mask = cycles_max << cycles_low;
  // Clocks, as the temperature converter counts them; 0 after reset. Above a sixteenth of a second for each charge a write is refused and locks nothing.
  std::uint32_t cycles{};

  [[gnu::always_inline]] static constexpr MaximumCount decode([[maybe_unused]] std::uint32_t word) {
    return {
      .cycles = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return cycles;
  }
};

// What the channel does, and what tripped it since its trips were cleared.
struct Status {
  static constexpr std::size_t count = 4;
  static constexpr std::uint32_t address_of(std::size_t index) {
    return base + 0x44u + 4u * static_cast<std::uint32_t>(index);
  }
  static constexpr unsigned gate_bit = 0;
  static constexpr std::uint32_t gate_mask = 1u << gate_bit;
  static constexpr unsigned permitted_bit = 1;
  static constexpr std::uint32_t permitted_mask = 1u << permitted_bit;
  static constexpr unsigned minimum_locked_bit = 2;
  static constexpr std::uint32_t minimum_locked_mask = 1u << minimum_locked_bit;
  static constexpr unsigned maximum_locked_bit = 3;
  static constexpr std::uint32_t maximum_locked_mask = 1u << maximum_locked_bit;
  static constexpr unsigned hot_locked_bit = 4;
  static constexpr std::uint32_t hot_locked_mask = 1u << hot_locked_bit;
  static constexpr unsigned settle_locked_bit = 5;
  static constexpr std::uint32_t settle_locked_mask = 1u << settle_locked_bit;
  static constexpr unsigned refused_bit = 6;
  static constexpr std::uint32_t refused_mask = 1u << refused_bit;
  static constexpr unsigned tripped_bit = 7;
  static constexpr std::uint32_t tripped_mask = 1u << tripped_bit;
  static constexpr unsigned watchdog_trip_bit = 8;
  static constexpr std::uint32_t watchdog_trip_mask = 1u << watchdog_trip_bit;
  static constexpr unsigned sensor_invalid_trip_bit = 9;
  static constexpr std::uint32_t sensor_invalid_trip_mask = 1u << sensor_invalid_trip_bit;
  static constexpr unsigned sensor_stale_trip_bit = 10;
  static constexpr std::uint32_t sensor_stale_trip_mask = 1u << sensor_stale_trip_bit;
  static constexpr unsigned too_hot_trip_bit = 11;
  static constexpr std::uint32_t too_hot_trip_mask = 1u << too_hot_trip_bit;
  static constexpr unsigned too_cold_trip_bit = 12;
  static constexpr std::uint32_t too_cold_trip_mask = 1u << too_cold_trip_bit;
  static constexpr unsigned limits_missing_trip_bit = 13;
  static constexpr std::uint32_t limits_missing_trip_mask = 1u << limits_missing_trip_bit;
  static constexpr unsigned emergency_stop_trip_bit = 14;
  static constexpr std::uint32_t emergency_stop_trip_mask = 1u << emergency_stop_trip_bit;
  static constexpr unsigned heats_unasked_trip_bit = 15;
  static constexpr std::uint32_t heats_unasked_trip_mask = 1u << heats_unasked_trip_bit;
  // The gate is open now.
  bool gate{};
  // Nothing forbids to heat now.
  bool permitted{};
  // The minimum count is set, until reset.
  bool minimum_locked{};
  // The maximum count is set, until reset.
  bool maximum_locked{};
  // The hot count is set, until reset.
  bool hot_locked{};
  // The settling time is set, until reset.
  bool settle_locked{};
  // A write to a limit was refused: it was locked, or the value out of bounds.
  bool refused{};
  // One of the trips below is latched: the gate stays closed.
  bool tripped{};
  // Software did not feed the watchdog in time while the channel was asked to heat, or fed it wrongly.
  bool watchdog_trip{};
  // The sensor gave faulty conversions only for longer than the sensor time-out.
  bool sensor_invalid_trip{};
  // The sensor gave no conversion for longer than the sensor time-out.
  bool sensor_stale_trip{};
  // The thermistor count fell below the minimum, whether heat was requested or not.
  bool too_hot_trip{};
  // The thermistor count rose above the maximum.
  bool too_cold_trip{};
  // Heating was requested before all four limits were set.
  bool limits_missing_trip{};
  // The emergency stop input was active.
  bool emergency_stop_trip{};
  // It got hotter while the gate had been closed for the settling time: the transistor or its wiring is broken.
  bool heats_unasked_trip{};

  [[gnu::always_inline]] static constexpr Status decode([[maybe_unused]] std::uint32_t word) {
    return {
      .gate = (word & 0x1u) != 0,
      .permitted = ((word >> 1u) & 0x1u) != 0,
      .minimum_locked = ((word >> 2u) & 0x1u) != 0,
      .maximum_locked = ((word >> 3u) & 0x1u) != 0,
      .hot_locked = ((word >> 4u) & 0x1u) != 0,
      .settle_locked = ((word >> 5u) & 0x1u) != 0,
      .refused = ((word >> 6u) & 0x1u) != 0,
      .tripped = ((word >> 7u) & 0x1u) != 0,
      .watchdog_trip = ((word >> 8u) & 0x1u) != 0,
      .sensor_invalid_trip = ((word >> 9u) & 0x1u) != 0,
      .sensor_stale_trip = ((word >> 10u) & 0x1u) != 0,
      .too_hot_trip = ((word >> 11u) & 0x1u) != 0,
      .too_cold_trip = ((word >> 12u) & 0x1u) != 0,
      .limits_missing_trip = ((word >> 13u) & 0x1u) != 0,
      .emergency_stop_trip = ((word >> 14u) & 0x1u) != 0,
      .heats_unasked_trip = ((word >> 15u) & 0x1u) != 0,
    };
  }
  constexpr std::uint32_t encode() const {
    return (gate ? 1u : 0u) |
           (permitted ? 1u : 0u) << 1u |
           (minimum_locked ? 1u : 0u) << 2u |
           (maximum_locked ? 1u : 0u) << 3u |
           (hot_locked ? 1u : 0u) << 4u |
           (settle_locked ? 1u : 0u) << 5u |
           (refused ? 1u : 0u) << 6u |
           (tripped ? 1u : 0u) << 7u |
           (watchdog_trip ? 1u : 0u) << 8u |
           (sensor_invalid_trip ? 1u : 0u) << 9u |
           (sensor_stale_trip ? 1u : 0u) << 10u |
           (too_hot_trip ? 1u : 0u) << 11u |
           (too_cold_trip ? 1u : 0u) << 12u |
           (limits_missing_trip ? 1u : 0u) << 13u |
           (emergency_stop_trip ? 1u : 0u) << 14u |
           (heats_unasked_trip ? 1u : 0u) << 15u;
  }
};

// Below this thermistor count heat that is not requested is a trip. Locks when written.
struct HotCount {
  static constexpr std::size_t count = 4;
  static constexpr std::uint32_t address_of(std::size_t index) {
    return base + 0x54u + 4u * static_cast<std::uint32_t>(index);
  }
  static constexpr unsigned cycles_low = 0, cycles_width = 32;
  static constexpr std::uint32_t cycles_max = 0xFFFFFFFFu, cycles_mask = cycles_max << cycles_low;
  // Clocks, as the temperature converter counts them; 0 after reset. Below eight times the floor of `minimum_count` a write is refused and locks nothing.
  std::uint32_t cycles{};

  [[gnu::always_inline]] static constexpr HotCount decode([[maybe_unused]] std::uint32_t word) {
    return {
      .cycles = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return cycles;
  }
};

// Time for which a gate must be closed before rising heat is not its own. Locks when written.
struct Settle {
  static constexpr std::size_t count = 4;
  static constexpr std::uint32_t address_of(std::size_t index) {
    return base + 0x64u + 4u * static_cast<std::uint32_t>(index);
  }
  static constexpr unsigned ticks_low = 0, ticks_width = 24;
  static constexpr std::uint32_t ticks_max = 0xFFFFFFu, ticks_mask = ticks_max << ticks_low;
  // In ticks of `tick_cycles` clocks; the largest number after reset. Above two minutes a write is refused and locks nothing.
  std::uint32_t ticks{};

  [[gnu::always_inline]] static constexpr Settle decode([[maybe_unused]] std::uint32_t word) {
    return {
      .ticks = (word & 0xFFFFFFu),
    };
  }
  constexpr std::uint32_t encode() const {
    return (ticks & 0xFFFFFFu);
  }
};

// The relay that gives all heaters their power. Open after reset; any trip, the watchdog or the emergency stop opens it until it is closed again.
struct Supply {
  static constexpr std::uint32_t address = base + 0x74u;
  static constexpr unsigned closed_bit = 0;
  static constexpr std::uint32_t closed_mask = 1u << closed_bit;
  static constexpr unsigned refused_bit = 1;
  static constexpr std::uint32_t refused_mask = 1u << refused_bit;
  static constexpr unsigned trip_opened_bit = 4;
  static constexpr std::uint32_t trip_opened_mask = 1u << trip_opened_bit;
  static constexpr unsigned watchdog_opened_bit = 5;
  static constexpr std::uint32_t watchdog_opened_mask = 1u << watchdog_opened_bit;
  static constexpr unsigned emergency_stop_opened_bit = 6;
  static constexpr std::uint32_t emergency_stop_opened_mask = 1u << emergency_stop_opened_bit;
  static constexpr unsigned veto_opened_bit = 7;
  static constexpr std::uint32_t veto_opened_mask = 1u << veto_opened_bit;
  static constexpr unsigned key_low = 16, key_width = 16;
  static constexpr std::uint32_t key_max = 0xFFFFu, key_mask = key_max << key_low;
  enum class Key : std::uint16_t {
    open = 3042,
    close = 49413,
  };
  // The heaters have power.
  bool closed{};
  // It was not closed when asked, because a duty was not 0 or a cause lasted.
  bool refused{};
  // A trip of a channel opened it.
  bool trip_opened{};
  // The watchdog opened it.
  bool watchdog_opened{};
  // The emergency stop opened it.
  bool emergency_stop_opened{};
  // The clock watch, or another veto on the board, opened it.
  bool veto_opened{};
  // Written: `close` closes it where all duties are 0 and no cause lasts, `open` opens it; anything else is ignored. Read: 0.
  Key key{};

  [[gnu::always_inline]] static constexpr Supply decode([[maybe_unused]] std::uint32_t word) {
    return {
      .closed = (word & 0x1u) != 0,
      .refused = ((word >> 1u) & 0x1u) != 0,
      .trip_opened = ((word >> 4u) & 0x1u) != 0,
      .watchdog_opened = ((word >> 5u) & 0x1u) != 0,
      .emergency_stop_opened = ((word >> 6u) & 0x1u) != 0,
      .veto_opened = ((word >> 7u) & 0x1u) != 0,
      .key = static_cast<Key>(((word >> 16u) & 0xFFFFu)),
    };
  }
  constexpr std::uint32_t encode() const {
    return (closed ? 1u : 0u) |
           (refused ? 1u : 0u) << 1u |
           (trip_opened ? 1u : 0u) << 4u |
           (watchdog_opened ? 1u : 0u) << 5u |
           (emergency_stop_opened ? 1u : 0u) << 6u |
           (veto_opened ? 1u : 0u) << 7u |
           (static_cast<std::uint32_t>(key) & 0xFFFFu) << 16u;
  }
};

}  // namespace registers::heater_control
