// SPDX-License-Identifier: Apache-2.0
// The machine timer shared with the ticks: drivers/timer.hpp where software makes the steps.
#include "drivers/timer.hpp"

#include "platform/bus.hpp"
#include "registers/timer_registers.hpp"
#include "software_stepping/chip_stepper.hpp"

namespace drivers {

units::Cycles Timer::now() const {
  // The interrupt reads the processor's clock counter and not this, so that nothing comes between.
  return units::Cycles(static_cast<std::int64_t>(platform::read<registers::timer::Time>().cycles));
}

std::uint32_t Timer::now_low() const { return platform::read<registers::timer::TimeLow>().cycles; }

void Timer::set_deadline(units::Cycles deadline) {
  software_stepping::chip_stepper().set_alarm(static_cast<std::uint64_t>(deadline.count()));
}

void Timer::clear_deadline() {
  software_stepping::chip_stepper().set_alarm(software_stepping::Stepper::never);
}

}  // namespace drivers
