// SPDX-License-Identifier: Apache-2.0
// For the netlists that the model of the processor does not replace.
#include <stdexcept>

#include "sim/replay/netlist_replay.hpp"
#include "sim/simulation/chip_model.hpp"

namespace sim {

std::unique_ptr<ChipModel> make_joined_model(std::uint32_t, Edges) { return nullptr; }

}  // namespace sim

namespace replay {

Replay make_netlist_replay(std::uint32_t, bool, sim::Edges) {
  throw std::runtime_error("this program has no netlist that replays");
}

}  // namespace replay
