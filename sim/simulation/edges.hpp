// SPDX-License-Identifier: Apache-2.0
// Which clock edges of the chip are evaluated.
#pragma once

#include <cstdint>

namespace sim {

// Those that change something; or all, which gives the same, more slowly, and serves to show it.
enum class Edges : std::uint8_t { needed, all };

}  // namespace sim
