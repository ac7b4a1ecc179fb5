// SPDX-License-Identifier: Apache-2.0
// The ways through a function as arcs with costs: what its longest time is computed from.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace timing {

using Clocks = std::uint64_t;

struct Arc {
  std::size_t from{}, to{};
  Clocks clocks{};
  // Networks that are passed once from start to end on this way, and their clocks in addition.
  std::vector<std::size_t> calls;
  // Facts, by number: an event that one limits; a beginning of a run for which it holds.
  std::vector<std::size_t> events, begins;
};

struct RoundsBound {
  std::size_t header{};
  std::vector<bool> nodes;
  Clocks most{};  // times back to the header for each time that it is entered
};

// Each run begins at node 0 and ends at `end`.
struct Network {
  std::size_t end{};  // the number of nodes before it
  std::vector<Arc> arcs;  // those into a node first, then those out of it, but for ways back
  std::vector<RoundsBound> loops;  // inner ones before those around them
  std::vector<std::size_t> entry_events, entry_begins;  // as those of an arc, in each run

  // A run begins at this node, and ends where it comes there again.
  void make_round(std::size_t start);
  // Arcs on no way to the end are left out, and nodes with one way in and one out.
  void reduce();
};

// How often the events of one kind happen at most, for each beginning of a run.
struct Fact {
  std::uint32_t event{}, most{};
  auto operator<=>(const Fact&) const = default;
};

// The first network is asked for; the others are those that it calls, directly or not.
struct Networks {
  std::vector<Network> networks;
  std::vector<Fact> facts;
};

}  // namespace timing
