// SPDX-License-Identifier: Apache-2.0
// The last resort of the firmware: everything off, a message to the host, and no watchdog fed.
#pragma once

#include <cstdint>

namespace platform {

// Ends all motion and heating, writes the trap's cause, place and address and how the program came
// there to the host, and halts for good. The hardware watchdogs then stop what software could not.
extern "C" [[noreturn]] void report_trap(std::uint32_t cause, std::uint32_t program_counter,
                                         std::uint32_t address, std::uint32_t stack_pointer,
                                         std::uint32_t return_address);

// The same for a fault that the program itself has found; `reason` is one line without line end.
[[noreturn]] void halt(const char* reason);

}  // namespace platform
