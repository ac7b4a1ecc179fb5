// SPDX-License-Identifier: Apache-2.0
// Which instructions of a function are reached from some registers, and what is known there.
#pragma once

#include <optional>
#include <vector>

#include "tools/timing/flow.hpp"
#include "tools/timing/state.hpp"

namespace timing {

struct Reached {
  std::vector<std::optional<State>> before;  // of each node that is reached
  std::optional<State> back;  // of what arrives at the start again
  std::size_t visits = 0;
};

class Reach {
 public:
  Reach(const Program& program, Flows& flows) : program_(program), flows_(flows) {}

  // The whole function.
  Reached all(const Flow& flow, const State& state) const;
  // From `start` within some nodes, until it comes to `start` again.
  Reached once(const Flow& flow, std::size_t start, const State& state,
               const std::vector<bool>& within) const;

  State after(const Node& node, State state) const;
  // Ways that are not known never to be taken.
  static std::vector<Way> ways(const Node& node, const State& before);
  // Where a call or a jump to a register goes, if that is known.
  static std::optional<Address> target(const Node& node, const State& before);

 private:
  Reached run(const Flow& flow, std::size_t start, const State& state,
              const std::vector<bool>* within) const;

  const Program& program_;
  Flows& flows_;
};

}  // namespace timing
