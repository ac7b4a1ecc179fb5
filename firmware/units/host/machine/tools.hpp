// SPDX-License-Identifier: Apache-2.0
// On hosts: the machine description says how many extruders there are.
#pragma once

#include <cstddef>

namespace units {

inline constexpr std::size_t most_tools = 2;

}  // namespace units
