// SPDX-License-Identifier: Apache-2.0
// The limits of motion as M-codes, as hosts read them.
#pragma once

#include <array>
#include <cstdint>

#include "application/machine_description.hpp"
#include "host_link/text_line.hpp"
#include "motion/limits.hpp"

namespace application {

// Whether M209 is fitted: in a chip that has room for it, and on a host.
extern const bool automatic_retraction_in_image;

// The commands that M503 lists, in Marlin's order; the last one where it is fitted.
inline constexpr std::array<std::uint16_t, 8> reported_settings{92,  203, 201, 204,
                                                                205, 207, 208, 209};

// "echo: M203 X200.00 Y200.00 Z12.00 E80.00", with the code of one of these commands. In s and
// in mm or inches, but steps always per mm.
host_link::TextLine setting_report(std::uint16_t code, const motion::Limits& limits, bool inches);

// "echo: M217 S8.00 B0.00 E0.00 P600.00 R2400.00 U1200.00 Z1.00"
host_link::TextLine backlash_report(const motion::BacklashSettings& backlash, bool inches);
host_link::TextLine tool_change_report(const ToolChange& change, bool inches);
// "echo: M218 T1 X18.000 Y0.000 Z0.000"
host_link::TextLine tool_offset_report(const ToolOffset& offset, bool inches);

}  // namespace application
