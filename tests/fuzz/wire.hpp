// SPDX-License-Identifier: Apache-2.0
// A file host and the firmware's host link, joined by a serial line.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sim/devices/gcode_file.hpp"

namespace fuzz {

// Prints the commands. Of the n-th line on the wire the byte `noise[n]`, counted from 1, has a
// flipped bit; 0 or nothing: none.
void print_over_wire(const std::vector<devices::FileCommand>& commands,
                     std::span<const std::uint8_t> noise);

}  // namespace fuzz
