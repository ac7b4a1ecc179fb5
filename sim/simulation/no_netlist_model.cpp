// SPDX-License-Identifier: Apache-2.0
// For chips that are simulated by the model of the processor alone.
#include <stdexcept>

#include "sim/replay/netlist_replay.hpp"
#include "sim/simulation/chip_model.hpp"

namespace sim {

std::unique_ptr<ChipModel> make_netlist_model(std::uint32_t, Edges) {
  throw std::runtime_error(
      "the chip of a machine with two extruders has no netlist of its processor: omit --processor "
      "netlist and --every-clock");
}

}  // namespace sim

namespace replay {

Replay make_netlist_replay(std::uint32_t, bool, sim::Edges) {
  throw std::runtime_error("this program has no netlist that replays");
}

}  // namespace replay
