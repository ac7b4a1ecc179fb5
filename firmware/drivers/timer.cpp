// SPDX-License-Identifier: Apache-2.0
// The machine timer's register halves put together.
#include "drivers/timer.hpp"

#include <cstdint>
#include <limits>

#include "drivers/registers/timer_registers.hpp"
#include "platform/bus.hpp"

namespace drivers {

namespace timer_registers = registers::timer;

units::Cycles Timer::now() const {
  // Reading the low half holds the high half of the same instant.
  const std::uint64_t low = platform::read<timer_registers::TimeLow>().cycles;
  const std::uint64_t high = platform::read<timer_registers::TimeHigh>().cycles;
  return units::Cycles(static_cast<std::int64_t>(high << 32 | low));
}

void Timer::set_deadline(units::Cycles deadline) {
  const auto cycles = static_cast<std::uint64_t>(deadline.count());
  platform::write(timer_registers::CompareLow{.cycles = static_cast<std::uint32_t>(cycles)});
  // Both halves take effect with this write.
  platform::write(timer_registers::CompareHigh{.cycles = static_cast<std::uint32_t>(cycles >> 32)});
}

void Timer::clear_deadline() {
  set_deadline(units::Cycles(std::numeric_limits<std::int64_t>::max()));
}

}  // namespace drivers
