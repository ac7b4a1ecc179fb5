// SPDX-License-Identifier: Apache-2.0
// The state of the processor's model, and the names of its parts.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "sim/processor/machine_state.hpp"
#include "sim/replay/snapshot.hpp"

namespace replay {

// Of a processor that sleeps at clock `now`.
ProcessorSnapshot snapshot_of(const processor::MachineState& state, sim::Clock now);

std::vector<std::pair<std::string, std::uint64_t>> named_values(const ProcessorSnapshot& snapshot);

}  // namespace replay
