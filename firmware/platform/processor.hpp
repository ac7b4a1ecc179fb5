// SPDX-License-Identifier: Apache-2.0
// What the tasks ask of the processor itself: sleep until something happens, clocks, the stack's
// guard.
#pragma once

#include <cstdint>

namespace platform {

// Bits of the interrupt enable register. Interrupts never run a handler: they end `sleep`.
enum class WakeSource : std::uint32_t {
  timer = 1u << 7,
  uart_receive = 1u << 16,
  queue_threshold = 1u << 17,
  motion_stopped = 1u << 18,
  heater_trip = 1u << 19,
  uart_transmit = 1u << 20,
};

void wake_by(WakeSource source, bool enabled);

// Waits until an enabled source is pending; returns at once if one is. Nothing can be missed
// between a task's last look and the sleep, because what happened in between is still pending.
void sleep();

// Clocks and completed instructions since reset, modulo 2^32.
std::uint32_t clocks();
std::uint32_t instructions();

// False once the lowest word of the stack has been written: the stack has met the variables below
// it.
bool stack_is_intact();

}  // namespace platform
