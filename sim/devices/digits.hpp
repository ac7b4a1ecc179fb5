// SPDX-License-Identifier: Apache-2.0
// Tests of characters for all readers of G-code on the host's side.
#pragma once

namespace devices {

// Of ASCII: std::isdigit asks a locale.
constexpr bool is_digit(char character) { return character >= '0' && character <= '9'; }

}  // namespace devices
