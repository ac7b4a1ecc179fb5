// SPDX-License-Identifier: Apache-2.0
// The tools of the machine: which one is in use, where its nozzle is, and what a change does. Empty
// in an image for one extruder.
#pragma once

#include <array>
#include <cstddef>

#include "application/machine_description.hpp"
#include "units/if_two_tools.hpp"

namespace application {

class Tools {
 public:
  // As the machine description has them; what is in use stays.
  void restore(const MachineDescription& machine);

  std::size_t count() const { return units::most_tools == 1 ? 1 : state().count; }
  std::size_t in_use() const { return units::most_tools == 1 ? 0 : state().in_use; }
  void select(std::size_t tool) { state().in_use = tool; }
  // M218. Only where there are two.
  const ToolOffset& offset(std::size_t tool) const { return state().offsets[tool]; }
  ToolOffset& offset(std::size_t tool) { return state().offsets[tool]; }
  // M217. Likewise.
  const ToolChange& change() const { return state().change; }
  ToolChange& change() { return state().change; }

 private:
  struct State {
    std::size_t count{1};
    std::size_t in_use{};
    std::array<ToolOffset, units::most_tools> offsets{};
    ToolChange change{};
  };

  State& state() { return state_[0]; }
  const State& state() const { return state_[0]; }

  [[no_unique_address]] units::IfTwoTools<State> state_{};
};

}  // namespace application
