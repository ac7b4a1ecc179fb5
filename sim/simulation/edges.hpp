// SPDX-License-Identifier: Apache-2.0
// Which clock edges of the chip are evaluated.
#pragma once

#include <cstdint>

namespace sim {

// As few as possible: many clocks in which blocks only count are carried over at once; or those of
// the blocks that are not at rest; or all. Each gives the same, more slowly, and serves to show it.
enum class Edges : std::uint8_t { leaping, resting, all };

}  // namespace sim
