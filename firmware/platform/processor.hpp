// SPDX-License-Identifier: Apache-2.0
// Functions of the processor itself: sleep until an interrupt, clock counts, the stack guard.
#pragma once

#include <cstdint>

#include "registers/interrupts.hpp"

namespace platform {

// Interrupts never run a handler: they end `sleep`.
using WakeSource = registers::Interrupt;

void wake_by(WakeSource source, bool enabled);

// Waits until an enabled source is pending; returns at once if one is. Nothing can be missed
// between a task's last look and the sleep, because what happened in between is still pending.
void sleep();

// Clocks and completed instructions since reset, modulo 2^32.
std::uint32_t clocks();
std::uint32_t instructions();

// False once the lowest word of the stack has been written: the stack has met the variables
// below it.
bool stack_is_intact();

}  // namespace platform
