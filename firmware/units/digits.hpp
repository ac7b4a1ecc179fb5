// SPDX-License-Identifier: Apache-2.0
// Tests of characters for all readers of numbers.
#pragma once

namespace units {

// Of ASCII: std::isdigit asks a locale.
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace units
