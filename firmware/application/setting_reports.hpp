// SPDX-License-Identifier: Apache-2.0
// The limits of motion as M-codes, as hosts read them.
#pragma once

#include <array>
#include <cstdint>

#include "host_link/text_line.hpp"
#include "motion/limits.hpp"

namespace application {

// The commands that M503 lists, in Marlin's order.
inline constexpr std::array<std::uint16_t, 7> reported_settings{92, 203, 201, 204, 205, 207, 208};

// "echo: M203 X200.00 Y200.00 Z12.00 E80.00", with the code of one of these commands. In s and
// in mm or inches, but steps always per mm.
host_link::TextLine setting_report(std::uint16_t code, const motion::Limits& limits, bool inches);

}  // namespace application
