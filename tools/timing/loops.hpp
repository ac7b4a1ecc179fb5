// SPDX-License-Identifier: Apache-2.0
// The natural loops of a graph.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace timing {

using Graph = std::vector<std::vector<std::size_t>>;  // the successors of each node

struct Loop {
  std::size_t header{};
  std::vector<bool> nodes;
  std::size_t size{};
};

struct Loops {
  std::vector<std::size_t> order;  // of all nodes reached from 0; a node comes after all ways to it
  std::vector<Loop> loops;  // inner ones before those around them
  std::optional<std::size_t> second_entry;  // of a loop that has several: it has no bound
};

Loops find_loops(const Graph& graph);

}  // namespace timing
