// SPDX-License-Identifier: Apache-2.0
// Sleep on the chip where no interrupt runs code: wfi, ended by whatever is pending. Only
// in the image.
#include "platform/processor.hpp"

namespace platform {

void wake_by(WakeSource source, bool enabled) {
  const auto bits = static_cast<std::uint32_t>(source);
  if (enabled) {
    asm volatile("csrs mie, %0" ::"r"(bits));
  } else {
    asm volatile("csrc mie, %0" ::"r"(bits));
  }
}

void sleep() { asm volatile("wfi" ::: "memory"); }

}  // namespace platform
