// SPDX-License-Identifier: Apache-2.0
// The netlist of the processor and the model that takes its place in simulations, clock by clock.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "sim/processor/decoder.hpp"

namespace processor {

struct ModelLockstepSettings {
  std::uint64_t clocks = 50'000;
  unsigned bus_wait = 1;
  // Interrupts are requested and withdrawn in any clocks; 0: none.
  std::uint32_t seed = 0;
  unsigned longest_pause = 60;
  // So many clocks at most the model runs ahead of the netlist, and is taken back where an
  // interrupt line changes meanwhile.
  unsigned longest_lead = 1;
};

struct ModelLockstep {
  std::string difference;  // empty: none
  std::uint64_t instructions = 0;
  std::uint64_t traps = 0;
  std::uint64_t accesses = 0;
  std::uint64_t sleeping_clocks = 0;
  // How often an instruction of an operation was interrupted, and how often an interrupt was taken
  // right after one.
  std::map<Operation, std::uint64_t> interrupted, behind;
};

// Same events in the same clocks, with the same values; the same memory at the end.
ModelLockstep run_model_lockstep(const std::vector<std::uint8_t>& image,
                                 const ModelLockstepSettings& settings);

}  // namespace processor
