// SPDX-License-Identifier: Apache-2.0
// Which clock edges of the chip are evaluated, and how the processor is simulated.
#pragma once

#include <cstdint>

namespace sim {

// `leaping`: clocks in which blocks only count are carried over many at once. `resting`: the edges
// of blocks at rest are left out. `all`: every edge. The results are the same; the others are
// slower, and show it.
enum class Edges : std::uint8_t { leaping, resting, all };

// `model`: sim/processor, with the netlist of all else. The results are those of the netlist, which
// is taken where a program holds no model of the processor.
enum class Processor : std::uint8_t { model, netlist };

}  // namespace sim
