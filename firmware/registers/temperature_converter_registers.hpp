// SPDX-License-Identifier: Apache-2.0
// Registers of `temperature_converter`. Generated from rtl/thermal/temperature_converter.toml: do not edit.
// clang-format off
#pragma once

#include <cstddef>
#include <cstdint>

// Temperature converter: measures thermistors by the time that a capacitor takes to charge.
namespace registers::temperature_converter {

inline constexpr std::uint32_t base = 0xF0005000u;

// How conversions are made. A change of settings, here or below, begins a new conversion; until it has ended the state is `never`. All but `enable` lock with the limits of the heaters.
struct Control {
  static constexpr std::uint32_t address = base + 0x0u;
  static constexpr unsigned enable_bit = 0;
  static constexpr std::uint32_t enable_mask = 1u << enable_bit;
  static constexpr unsigned references_bit = 1;
  static constexpr std::uint32_t references_mask = 1u << references_bit;
  static constexpr unsigned dither_cycles_low = 8, dither_cycles_width = 8;
  static constexpr std::uint32_t dither_cycles_max = 0xFFu, dither_cycles_mask = dither_cycles_max << dither_cycles_low;
  static constexpr unsigned more_charges_low = 16, more_charges_width = 8;
  static constexpr std::uint32_t more_charges_max = 0xFFu, more_charges_mask = more_charges_max << more_charges_low;
  // Convert all channels without end. When 0, all charge pins are high-impedance.
  bool enable{};
  // The two reference resistors are there: discharge through them too and measure them.
  bool references{};
  // Clocks by which the precharge through the high reference grows from charge to charge.
  std::uint32_t dither_cycles{};
  // Charges per resistor and conversion, less one.
  std::uint32_t more_charges{};

  [[gnu::always_inline]] static constexpr Control decode([[maybe_unused]] std::uint32_t word) {
    return {
      .enable = (word & 0x1u) != 0,
      .references = ((word >> 1u) & 0x1u) != 0,
      .dither_cycles = ((word >> 8u) & 0xFFu),
      .more_charges = ((word >> 16u) & 0xFFu),
    };
  }
  constexpr std::uint32_t encode() const {
    return (enable ? 1u : 0u) |
           (references ? 1u : 0u) << 1u |
           (dither_cycles & 0xFFu) << 8u |
           (more_charges & 0xFFu) << 16u;
  }
};

// Time to discharge the capacitor before each charge.
struct Discharge {
  static constexpr std::uint32_t address = base + 0x4u;
  static constexpr unsigned cycles_low = 0, cycles_width = 24;
  static constexpr std::uint32_t cycles_max = 0xFFFFFFu, cycles_mask = cycles_max << cycles_low;
  // In clocks.
  std::uint32_t cycles{};

  [[gnu::always_inline]] static constexpr Discharge decode([[maybe_unused]] std::uint32_t word) {
    return {
      .cycles = (word & 0xFFFFFFu),
    };
  }
  constexpr std::uint32_t encode() const {
    return (cycles & 0xFFFFFFu);
  }
};

// Longest time that one charge may take.
struct Timeout {
  static constexpr std::uint32_t address = base + 0x8u;
  static constexpr unsigned cycles_low = 0, cycles_width = 24;
  static constexpr std::uint32_t cycles_max = 0xFFFFFFu, cycles_mask = cycles_max << cycles_low;
  // In clocks; cut to the maximum that is built in, an eighth of a second.
  std::uint32_t cycles{};

  [[gnu::always_inline]] static constexpr Timeout decode([[maybe_unused]] std::uint32_t word) {
    return {
      .cycles = (word & 0xFFFFFFu),
    };
  }
  constexpr std::uint32_t encode() const {
    return (cycles & 0xFFFFFFu);
  }
};

// Time between conversions, with the capacitor discharged.
struct Pause {
  static constexpr std::uint32_t address = base + 0xCu;
  static constexpr unsigned cycles_low = 0, cycles_width = 24;
  static constexpr std::uint32_t cycles_max = 0xFFFFFFu, cycles_mask = cycles_max << cycles_low;
  // In clocks.
  std::uint32_t cycles{};

  [[gnu::always_inline]] static constexpr Pause decode([[maybe_unused]] std::uint32_t word) {
    return {
      .cycles = (word & 0xFFFFFFu),
    };
  }
  constexpr std::uint32_t encode() const {
    return (cycles & 0xFFFFFFu);
  }
};

// Below this thermistor count the thermistor is taken as shorted.
struct ShortLimit {
  static constexpr std::uint32_t address = base + 0x10u;
  static constexpr unsigned cycles_low = 0, cycles_width = 32;
  static constexpr std::uint32_t cycles_max = 0xFFFFFFFFu, cycles_mask = cycles_max << cycles_low;
  // Sum of all charges of a conversion, in clocks.
  std::uint32_t cycles{};

  [[gnu::always_inline]] static constexpr ShortLimit decode([[maybe_unused]] std::uint32_t word) {
    return {
      .cycles = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return cycles;
  }
};

// Outcome of the channel's newest conversion.
struct Status {
  static constexpr std::size_t count = 4;
  static constexpr std::uint32_t address_of(std::size_t index) {
    return base + 0x14u + 4u * static_cast<std::uint32_t>(index);
  }
  static constexpr unsigned state_low = 0, state_width = 3;
  static constexpr std::uint32_t state_max = 0x7u, state_mask = state_max << state_low;
  static constexpr unsigned conversions_low = 8, conversions_width = 8;
  static constexpr std::uint32_t conversions_max = 0xFFu, conversions_mask = conversions_max << conversions_low;
  enum class State : std::uint8_t {
    never = 0,
    ok = 1,
    open = 2,
    shorted = 3,
    stuck = 4,
    time_out = 5,
  };
  // never: no conversion with these settings yet; open: only the thermistor timed out; stuck: the pin reads 1 after the discharge; time_out: no charge arrives at all.
  State state{};
  // Counts conversions, modulo 256. Unchanged after reading the counts, they belong together.
  std::uint32_t conversions{};

  [[gnu::always_inline]] static constexpr Status decode([[maybe_unused]] std::uint32_t word) {
    return {
      .state = static_cast<State>((word & 0x7u)),
      .conversions = ((word >> 8u) & 0xFFu),
    };
  }
  constexpr std::uint32_t encode() const {
    return (static_cast<std::uint32_t>(state) & 0x7u) |
           (conversions & 0xFFu) << 8u;
  }
};

// Time since the channel's newest conversion.
struct Age {
  static constexpr std::size_t count = 4;
  static constexpr std::uint32_t address_of(std::size_t index) {
    return base + 0x24u + 4u * static_cast<std::uint32_t>(index);
  }
  static constexpr unsigned ticks_low = 0, ticks_width = 20;
  static constexpr std::uint32_t ticks_max = 0xFFFFFu, ticks_mask = ticks_max << ticks_low;
  // In ticks of `tick_cycles` clocks, as those of heater_control; stays at its largest value.
  std::uint32_t ticks{};

  [[gnu::always_inline]] static constexpr Age decode([[maybe_unused]] std::uint32_t word) {
    return {
      .ticks = (word & 0xFFFFFu),
    };
  }
  constexpr std::uint32_t encode() const {
    return (ticks & 0xFFFFFu);
  }
};

// Clocks of all charges through the thermistor.
struct Thermistor {
  static constexpr std::size_t count = 4;
  static constexpr std::uint32_t address_of(std::size_t index) {
    return base + 0x34u + 4u * static_cast<std::uint32_t>(index);
  }
  static constexpr unsigned cycles_low = 0, cycles_width = 32;
  static constexpr std::uint32_t cycles_max = 0xFFFFFFFFu, cycles_mask = cycles_max << cycles_low;
  // Sum over the charges of the conversion.
  std::uint32_t cycles{};

  [[gnu::always_inline]] static constexpr Thermistor decode([[maybe_unused]] std::uint32_t word) {
    return {
      .cycles = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return cycles;
  }
};

// Clocks of all charges through the low reference resistor.
struct ReferenceLow {
  static constexpr std::size_t count = 4;
  static constexpr std::uint32_t address_of(std::size_t index) {
    return base + 0x44u + 4u * static_cast<std::uint32_t>(index);
  }
  static constexpr unsigned cycles_low = 0, cycles_width = 32;
  static constexpr std::uint32_t cycles_max = 0xFFFFFFFFu, cycles_mask = cycles_max << cycles_low;
  // Sum over the charges of the conversion; 0 without references.
  std::uint32_t cycles{};

  [[gnu::always_inline]] static constexpr ReferenceLow decode([[maybe_unused]] std::uint32_t word) {
    return {
      .cycles = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return cycles;
  }
};

// Clocks of all charges through the high reference resistor.
struct ReferenceHigh {
  static constexpr std::size_t count = 4;
  static constexpr std::uint32_t address_of(std::size_t index) {
    return base + 0x54u + 4u * static_cast<std::uint32_t>(index);
  }
  static constexpr unsigned cycles_low = 0, cycles_width = 32;
  static constexpr std::uint32_t cycles_max = 0xFFFFFFFFu, cycles_mask = cycles_max << cycles_low;
  // Sum over the charges of the conversion; 0 without references.
  std::uint32_t cycles{};

  [[gnu::always_inline]] static constexpr ReferenceHigh decode([[maybe_unused]] std::uint32_t word) {
    return {
      .cycles = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return cycles;
  }
};

// The settings are locked while any limit of a heater is: they are the scale of the limits.
struct SettingsLock {
  static constexpr std::uint32_t address = base + 0x64u;
  static constexpr unsigned locked_bit = 0;
  static constexpr std::uint32_t locked_mask = 1u << locked_bit;
  static constexpr unsigned refused_bit = 1;
  static constexpr std::uint32_t refused_mask = 1u << refused_bit;
  // The settings cannot be changed.
  bool locked{};
  // A write that would have changed a locked setting was refused; written 1 it is forgotten.
  bool refused{};

  [[gnu::always_inline]] static constexpr SettingsLock decode([[maybe_unused]] std::uint32_t word) {
    return {
      .locked = (word & 0x1u) != 0,
      .refused = ((word >> 1u) & 0x1u) != 0,
    };
  }
  constexpr std::uint32_t encode() const {
    return (locked ? 1u : 0u) |
           (refused ? 1u : 0u) << 1u;
  }
};

}  // namespace registers::temperature_converter
