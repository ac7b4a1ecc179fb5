// SPDX-License-Identifier: Apache-2.0
// What M115 says that the firmware can do. It is what is true, not what would please: hosts act on
// what they read there.
#pragma once

#include <array>

#include "host_link/replies.hpp"

namespace application {

inline constexpr std::size_t capability_count = 10;

// The last one is as the machine description says.
const std::array<host_link::Capability, capability_count>& capabilities();

}  // namespace application
