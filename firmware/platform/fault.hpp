// SPDX-License-Identifier: Apache-2.0
// The end of the firmware's control: everything off, a last word to the host, and nothing
// fed any more.
#pragma once

#include <cstdint>

namespace platform {

// Ends all motion and heating, writes the trap's cause, place and address and how the program
// came there to the host, and halts for good. Hardware watchdogs then act on what software
// could not reach.
extern "C" [[noreturn]] void report_trap(std::uint32_t cause, std::uint32_t program_counter,
                                         std::uint32_t address, std::uint32_t stack_pointer,
                                         std::uint32_t return_address);

// The same for a fault that the program itself has found; `reason` is one line without line end.
[[noreturn]] void halt(const char* reason);

}  // namespace platform
