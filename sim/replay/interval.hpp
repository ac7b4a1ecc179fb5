// SPDX-License-Identifier: Apache-2.0
// A stretch of a simulation: all that goes into the chip, and all that must come out.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "sim/replay/snapshot.hpp"

namespace replay {

struct InputChange {
  sim::Clock clock{};  // sampled by the edge after it
  sim::InputPins pins;
};

struct OutputChange {
  sim::Clock clock{};
  sim::OutputPins pins;
};

struct Interval {
  std::size_t number{};  // from 1
  std::shared_ptr<const Snapshot> start;
  // The first are those that the chip has had at the start; others may follow in the same clock.
  std::vector<InputChange> inputs;
  std::vector<OutputChange> outputs;
  sim::Clock end_clock{};
  std::shared_ptr<const Snapshot> end;  // null where the simulation ended before one could be taken
};

}  // namespace replay
