// SPDX-License-Identifier: Apache-2.0
// The capabilities that M115 reports. They must be true, because hosts rely on them.
#pragma once

#include <array>

#include "host_link/replies.hpp"

namespace application {

inline constexpr std::size_t capability_count = 10;

// The last one is as the machine description says.
const std::array<host_link::Capability, capability_count>& capabilities();

}  // namespace application
