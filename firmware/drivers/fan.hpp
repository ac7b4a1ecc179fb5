// SPDX-License-Identifier: Apache-2.0
// The fan: duty and frequency of its pulse-width modulation.
#pragma once

#include <cstdint>

#include "units/quantity.hpp"

namespace drivers {

class Fan {
 public:
  static constexpr std::uint8_t full_duty = 255;

  // Clocks of one of the 255 slots of a period, rounded to nearest, within what the register holds.
  static constexpr std::uint32_t slot_cycles(units::Hertz frequency, units::Hertz clock) {
    const std::uint64_t slots_per_second = std::uint64_t{frequency.count()} * full_duty;
    if (slots_per_second == 0) return longest_slot_cycles;
    const std::uint64_t cycles = (clock.count() + slots_per_second / 2) / slots_per_second;
    if (cycles == 0) return 1;
    return cycles > longest_slot_cycles ? longest_slot_cycles : static_cast<std::uint32_t>(cycles);
  }

  // How often the fan is switched on; the nearest that the clock can do.
  void set_frequency(units::Hertz frequency, units::Hertz clock);
  // 0 is off, `full_duty` always on. Takes effect with the next period.
  void set_duty(std::uint8_t duty);
  std::uint8_t duty() const;

 private:
  static constexpr std::uint32_t longest_slot_cycles = 0xFF'FFFF;
};

}  // namespace drivers
