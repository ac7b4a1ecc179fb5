// SPDX-License-Identifier: Apache-2.0
// The interface to the model that replays, for code that does not depend on a model.
#pragma once

#include <cstdint>

#include "sim/replay/interval_check.hpp"
#include "sim/simulation/edges.hpp"

namespace replay {

// Replays intervals by the netlist of the whole chip. Throws std::runtime_error where the program
// holds no such netlist: with the debug port, or traced.
Replay make_netlist_replay(std::uint32_t clock_hz, bool software_stepping, sim::Edges edges);

}  // namespace replay
