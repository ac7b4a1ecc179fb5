// SPDX-License-Identifier: Apache-2.0
// The fan's registers.
#include "drivers/fan.hpp"

#include "platform/bus.hpp"
#include "registers/fan_registers.hpp"

namespace drivers {

namespace fan_registers = registers::fan;

void Fan::set_frequency(units::Hertz frequency, units::Hertz clock) {
  platform::write(fan_registers::Period{.slot_cycles = slot_cycles(frequency, clock)});
}

void Fan::set_duty(std::uint8_t duty) { platform::write(fan_registers::Duty{.slots = duty}); }

std::uint8_t Fan::duty() const {
  return static_cast<std::uint8_t>(platform::read<fan_registers::Duty>().slots);
}

}  // namespace drivers
