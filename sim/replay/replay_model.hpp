// SPDX-License-Identifier: Apache-2.0
// The netlist of the whole chip, put into the state of a snapshot.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "sim/replay/chip_registers.hpp"
#include "sim/replay/interval_check.hpp"
#include "sim/simulation/netlist_model.hpp"

namespace replay {

class ReplayModel : public sim::NetlistModel {
 public:
  ReplayModel(std::uint32_t clock_hz, bool software_stepping, sim::Edges edges);

  // Goes through an interval from its start. Returns where pins, or the state at the end, are first
  // not what was recorded. Throws HardwareAssertion where one of the netlist's assertions fails.
  std::optional<Difference> replay(const Interval& interval);

  // The chip as it was, whatever this one has done before.
  void put(const Snapshot& snapshot, const sim::InputPins& inputs);

  // The first difference to a snapshot of this clock, if any.
  std::optional<Difference> difference(const Snapshot& snapshot) const;

  // Whether the register of this name has to be as in the snapshot: all but two have.
  static bool is_compared(std::string_view name);
  // Whether it differs between a chip whose blocks rest and one that evaluates every clock.
  static bool is_sample(std::string_view name);

 protected:
  const std::vector<Register>& registers() const { return registers_; }

 private:
  void put_registers(const Snapshot& snapshot);
  std::optional<Difference> processor_difference(const Snapshot& snapshot) const;
  std::optional<Difference> register_difference(const Snapshot& snapshot) const;
  std::optional<Difference> memory_difference(const Snapshot& snapshot) const;

  sim::Edges edges_;
  std::vector<Register> registers_;
};

}  // namespace replay
