// SPDX-License-Identifier: Apache-2.0
// Sleep that ticks interrupt without ending it: platform/processor.hpp where software makes the
// steps. Only in the image.
#include "platform/processor.hpp"
#include "software_stepping/chip_stepper.hpp"
#include "software_stepping/interrupts.hpp"

namespace platform {
namespace {

constexpr auto timer = static_cast<std::uint32_t>(WakeSource::timer);
std::uint32_t sources = timer;

std::uint32_t pending() {
  std::uint32_t bits;
  asm volatile("csrr %0, mip" : "=r"(bits));
  return bits;
}

}  // namespace

void wake_by(WakeSource source, bool enabled) {
  const auto bits = static_cast<std::uint32_t>(source);
  sources = enabled ? sources | bits : sources & ~bits;
}

// Only the timer interrupts the tasks; the others end wfi, for which they are enabled here alone.
void sleep() {
  const auto& stepper = software_stepping::chip_stepper();
  const std::uint32_t others = sources & ~timer;
  for (;;) {
    const software_stepping::WithoutInterrupts guarded;
    if (stepper.stopped() || stepper.alarm_has_passed()) return;
    if (others == 0) {
      asm volatile("wfi" ::: "memory");
      continue;
    }
    if ((pending() & others) != 0) return;
    asm volatile("csrw mie, %0" ::"r"(sources));
    asm volatile("wfi" ::: "memory");
    asm volatile("csrw mie, %0" ::"r"(timer));
  }
}

}  // namespace platform
