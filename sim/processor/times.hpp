// SPDX-License-Identifier: Apache-2.0
// The table of times of rtl/processor/timing.md: the clocks that the model adds to an instruction's
// one. A test compares the two.
#pragma once

#include <cstdint>

namespace processor::times {

// Clocks in which nothing executes, after an instruction or a trap.
inline constexpr std::uint8_t predicted_taken = 1;  // branch that is predicted taken, and is
inline constexpr std::uint8_t mispredicted = 2;
inline constexpr std::uint8_t jump = 1;
inline constexpr std::uint8_t jump_register = 2;
inline constexpr std::uint8_t fence_i = 2;
inline constexpr std::uint8_t trap_return = 3;
inline constexpr std::uint8_t trap = 3;  // exception, refused access, interrupt

// In addition to its first clock.
inline constexpr std::uint8_t division = 17;
inline constexpr std::uint8_t late_result_used = 1;

// From the clock of the request, in which the lines have their level, to that in which an
// interrupt is taken, or wfi retires.
inline constexpr std::uint8_t interrupt_seen = 1;
// From a return to the first clock in which an interrupt can be taken.
inline constexpr std::uint8_t interrupt_after_return = 2;

}  // namespace processor::times
