// SPDX-License-Identifier: Apache-2.0
// Chosen in an image for machines with a table [tool_1].
#pragma once

#include <cstddef>

namespace units {

inline constexpr std::size_t most_tools = 2;

}  // namespace units
