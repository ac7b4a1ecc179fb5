// SPDX-License-Identifier: Apache-2.0
// A model used by VerilatedChip, and the functions that create it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "sim/replay/snapshot.hpp"
#include "sim/simulation/chip.hpp"
#include "sim/simulation/edges.hpp"
#include "sim/simulation/evaluation_counts.hpp"

namespace sim {

class ChipModel : public Chip {
 public:
  virtual void permit_software_stepping() = 0;
  // Before anything is loaded. Throws where the model cannot have more than the chip.
  virtual void set_memory_bytes(std::uint32_t bytes) = 0;
  virtual void count_into(EvaluationCounts& counts) = 0;

  // Whether snapshot() ever has one.
  virtual bool takes_snapshots() const { return false; }
  // The state now, where the processor is in reset or has been asleep for some clocks.
  virtual std::optional<replay::Snapshot> snapshot() const { return std::nullopt; }
};

inline constexpr int reset_clocks = 8;

// All of the chip by its netlist.
std::unique_ptr<ChipModel> make_netlist_model(std::uint32_t clock_hz, Edges edges);

// A model of the processor with its memory, and the netlist of all else. Null where the program
// holds a netlist that the model does not replace: with the debug port, or traced.
std::unique_ptr<ChipModel> make_joined_model(std::uint32_t clock_hz, Edges edges);

}  // namespace sim
