// SPDX-License-Identifier: Apache-2.0
// The settings of a pseudo-terminal, reached through its master at any time.
#pragma once

#include <cstdint>

namespace devices {

// No echo, no translation, 8 bits, and this speed. Throws std::system_error.
void set_raw(int terminal, std::uint32_t baud);

// The speed that the program at the other end has chosen, any number; 0 where it is not known.
std::uint32_t baud_of(int terminal);

}  // namespace devices
