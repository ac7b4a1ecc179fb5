// SPDX-License-Identifier: Apache-2.0
// What a line that a person types is, before it is sent.
#pragma once

#include <cstdint>
#include <string_view>

namespace feeder {

std::string_view without_blanks(std::string_view text);

// The code of an M command as the firmware reads it: 112 of M112, m112;x, M 0112; 0 of any other
// line, M0 too.
std::int64_t m_code_of(std::string_view text);

// Whether it can be sent into a running print: it asks, or sets what does not change where the
// print's lines go (heat, fan, speed, flow, accelerations). Moves, homing, coordinates, units,
// motors and waits are not.
bool is_harmless(std::string_view text);

}  // namespace feeder
