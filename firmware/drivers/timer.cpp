// SPDX-License-Identifier: Apache-2.0
// The machine timer.
#include "drivers/timer.hpp"

#include <cstdint>
#include <limits>

#include "platform/bus.hpp"
#include "registers/timer_registers.hpp"

namespace drivers {

namespace timer_registers = registers::timer;

units::Cycles Timer::now() const {
  return units::Cycles(static_cast<std::int64_t>(platform::read<timer_registers::Time>().cycles));
}

std::uint32_t Timer::now_low() const { return platform::read<timer_registers::TimeLow>().cycles; }

void Timer::set_deadline(units::Cycles deadline) {
  platform::write(timer_registers::Compare{.cycles = static_cast<std::uint64_t>(deadline.count())});
}

void Timer::clear_deadline() {
  set_deadline(units::Cycles(std::numeric_limits<std::int64_t>::max()));
}

}  // namespace drivers
